// The page's script is packed: three.js, sss_three.js and three.page.js as one module. What is missing here is said in the page.
const message = document.getElementById('message');
const refuse = e => { message.textContent = e && e.message || String(e); };
window.onerror = (text, _, __, ___, e) => refuse(e || text);
window.onunhandledrejection = e => refuse(e.reason);
if (!window.DecompressionStream) throw new Error('This page wants a browser of 2023 or later: DecompressionStream is missing.');
if (!document.createElement('canvas').getContext('webgl2')) throw new Error('This page wants WebGL 2, which this browser does not offer; three.js draws with it.');
const bytes = Uint8Array.from(atob(document.getElementById('packed').textContent), c => c.charCodeAt(0));
const script = document.createElement('script');
script.type = 'module';
script.textContent = await new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).text();
document.body.append(script);
