// What examples/web/babylon.html shows: a scene by Babylon.js with its own subsurface pass and with ours, and both passes on light
// whose scattering is known.
const $ = id => document.getElementById(id);
const make = (tag, props = {}, ...inside) => { const e = Object.assign(document.createElement(tag), props); e.append(...inside); return e; };
const view = window.view = { ready: false, measured: null };
const option = (name, otherwise) => Number(new URLSearchParams(location.search).get(name)) || otherwise; // for tests on slow machines
const refuse = e => { view.refused = true; $('message').textContent = e && e.message || String(e); $('message').hidden = false; };
window.onerror = (text, _, __, ___, e) => refuse(e || text);
window.onunhandledrejection = e => refuse(e.reason);

// ---------------------------------------------------------------------------------------------------------------- the scene
async function scene() {
  const B = BABYLON, engine = view.engine = new B.Engine($('view'), true, { stencil: true, preserveDrawingBuffer: true }), s = view.scene = new B.Scene(engine);
  s.clearColor = new B.Color4(0.022, 0.028, 0.042, 1);
  s.imageProcessingConfiguration.toneMappingEnabled = true;
  s.imageProcessingConfiguration.exposure = 1.7;
  const camera = view.camera = new B.ArcRotateCamera('eye', -1.35, 1.35, 8.4, new B.Vector3(0.05, -0.05, 0), s);
  Object.assign(camera, { fov: 0.52, minZ: 0.5, maxZ: 60, lowerRadiusLimit: 5, upperRadiusLimit: 14 });
  camera.attachControl($('frame'), true);
  const lamp = new B.DirectionalLight('lamp', new B.Vector3(-1, -1, 1), s), sky = new B.HemisphericLight('sky', new B.Vector3(0, 1, 0), s);
  lamp.intensity = 2.4; // light before the albedo stays below 1, where Babylon's prepass ends
  lamp.diffuse = new B.Color3(1, 0.9, 0.78);
  sky.intensity = 0.16;
  sky.diffuse = new B.Color3(0.6, 0.7, 0.9);
  const shadows = new B.ShadowGenerator(1024, lamp);
  shadows.usePercentageCloserFiltering = true;
  shadows.bias = 0.01;
  shadows.normalBias = 0.02;
  const solid = (name, color, roughness) => {
    const m = new B.PBRMaterial(name, s);
    return Object.assign(m, { albedoColor: B.Color3.FromHexString(color).toLinearSpace(), metallic: 0, roughness });
  };
  const skin = solid('skin', '#c58c6e', 0.5), marble = solid('marble', '#e9e4da', 0.35), floor = solid('floor', '#4a5058', 0.9);
  const add = (mesh, material, x, y, z) => {
    mesh.position.set(x, y, z);
    mesh.material = material;
    mesh.receiveShadows = true;
    shadows.addShadowCaster(mesh);
    return mesh;
  };
  const face = add(B.MeshBuilder.CreateSphere('face', { diameter: 2, segments: 128, updatable: true }, s), skin, -2.05, 0, 0); // a ball with folds
  const at = face.getVerticesData('position'), normals = [];
  for (let i = 0; i < at.length; i += 3) {
    const [x, y, z] = at.slice(i, i + 3), k = 1 + 0.05 * Math.sin(9 * x + 2 * y) * Math.sin(8 * y) + 0.03 * Math.sin(17 * z);
    at[i] *= k; at[i + 1] *= k; at[i + 2] *= k;
  }
  B.VertexData.ComputeNormals(at, face.getIndices(), normals);
  face.updateVerticesData('position', at);
  face.updateVerticesData('normal', normals);
  add(B.MeshBuilder.CreateTorusKnot('knot', { radius: 0.72, tube: 0.25, radialSegments: 256, tubularSegments: 48 }, s), marble, 0.25, 0, 0);
  const cup = [[0.02, -1], [0.6, -0.85], [0.95, -0.3], [1, 0.6], [0.95, 0.6], [0.9, -0.28], [0.55, -0.78], [0.02, -0.93]].map(([x, y]) => new B.Vector3(x, y, 0));
  add(B.MeshBuilder.CreateLathe('cup', { shape: cup, tessellation: 96, closed: false, sideOrientation: B.Mesh.DOUBLESIDE }, s), marble, 2.35, 0, 0);
  add(B.MeshBuilder.CreateGround('floor', { width: 40, height: 40 }, s), floor, 0, -1.1, 0);
  const pose = () => {
    const a = $('turn').value * Math.PI / 180;
    lamp.direction.set(-0.87 * Math.sin(a), -0.48, 0.87 * Math.cos(a));
    lamp.position = lamp.direction.scale(-9);
  };
  const tall = $('frame').clientHeight * devicePixelRatio, widest = 12 / 40 / (2 * 8.4 * Math.tan(0.26)) * tall; // 12 mm of 40 mm a unit, 8.4 units away
  view.sss = await BabylonSubsurface.create(B, s, [
    { reflectance: [0.44, 0.22, 0.13], path: [1.8, 1.2, 0.73] },
    { reflectance: [0.83, 0.79, 0.75], path: [0.41, 0.66, 1.03] }], { mmPerUnit: 40, radius: Math.min(widest, 150) });
  view.sss.apply(skin, 0);
  view.sss.apply(marble, 1);
  const left = $('theirs'), paper = left.getContext('2d');
  const frame = ours => { view.sss.enabled = ours; s.render(); };
  view.draw = () => { // Babylon's own, kept in a canvas above; then ours
    pose();
    frame(false);
    Object.assign(left, { width: $('view').width, height: $('view').height });
    paper.drawImage($('view'), 0, 0);
    frame(true);
    const at = 100 * $('split').value;
    left.style.clipPath = `inset(0 ${100 - at}% 0 0)`;
    $('line').style.left = `calc(${at}% - 1px)`;
  };
  let wanted = false;
  const soon = view.soon = () => { if (!wanted) { wanted = true; requestAnimationFrame(() => { wanted = false; view.draw(); }); } };
  camera.onViewMatrixChangedObservable.add(soon);
  $('turn').oninput = soon;
  $('split').oninput = () => { const at = 100 * $('split').value; left.style.clipPath = `inset(0 ${100 - at}% 0 0)`; $('line').style.left = `calc(${at}% - 1px)`; };
  new ResizeObserver(() => { engine.resize(); soon(); }).observe($('frame'));
  for (const ours of [false, true]) { // until every shader is compiled
    view.sss.enabled = ours;
    pose();
    s.render();
    await s.whenReadyAsync();
    for (let k = 0; k < 3; ++k) { s.render(); await new Promise(r => setTimeout(r, 20)); }
  }
  view.draw();
}

// ---------------------------------------------------------------------------------------------------------------- the truth
const half = h => (h & 0x8000 ? -1 : 1) * ((h & 0x7c00) === 0 ? (h & 1023) * 2 ** -24 : (1 + (h & 1023) / 1024) * 2 ** ((h >> 10 & 31) - 15));
async function unpack(id) {
  const bytes = Uint8Array.from(atob($(id).textContent), c => c.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}
// A file of tests/render/truth_data.c, and its profile as rings: their edges, then three channels.
async function truth(name) {
  const buffer = await unpack(name), bytes = new Uint8Array(buffer), end = bytes.indexOf(10) + 1, [, width, height, fov, mm] = new TextDecoder().decode(bytes.subarray(0, end)).split(' ').map(Number);
  const n = width * height, data = new DataView(buffer, end), depth = new Float32Array(n), light = new Float32Array(4 * n), walk = new Float32Array(3 * n);
  let nearest = Infinity;
  for (let i = 0; i < n; ++i) {
    depth[i] = data.getFloat32(4 * i, true);
    if (depth[i] > 0) nearest = Math.min(nearest, depth[i]);
    light[4 * i + 3] = depth[i] > 0 ? 0 : 1; // where Babylon keeps the profile's index, 255 beside the object
    for (let c = 0; c < 3; ++c) {
      light[4 * i + c] = half(data.getUint16(4 * n + 12 * i + 2 * c, true));
      walk[3 * i + c] = half(data.getUint16(4 * n + 12 * i + 6 + 2 * c, true));
    }
  }
  const rows = $(name + '-profile').textContent.trim().split('\n').filter(l => /^[0-9]/.test(l)).map(l => l.split(',').map(Number)), edges = [0];
  for (const [r] of rows) edges.push(2 * r - edges.at(-1));
  let energy = [0, 0, 0], moment = [0, 0, 0]; // for the mean distance, which is 2.5 d of Burley's profile
  rows.forEach(([r, ...v], i) => { for (let c = 0; c < 3; ++c) { const e = v[c] * (edges[i + 1] ** 2 - edges[i] ** 2); energy[c] += e; moment[c] += e * r; } });
  return { name, width, height, fov, mm, depth, light, walk, nearest, rings: [...edges, ...[1, 2, 3].flatMap(c => rows.map(r => r[c]))], count: rows.length, d: moment.map((m, c) => m / energy[c] / 2.5) };
}

// Both passes in a context of their own: Babylon's text as the engine has it, ours as the scene has it.
function bench() {
  const gl = make('canvas', { width: 1, height: 1 }).getContext('webgl2');
  if (!gl || !gl.getExtension('EXT_color_buffer_float')) throw new Error('The comparison wants float targets in WebGL 2.');
  const store = BABYLON.Effect.IncludesShadersStore, include = text => text.replace(/#include<(\w+)>/g, (_, name) => include(store[name]));
  const own = include(BABYLON.Effect.ShadersStore.subSurfaceScatteringPixelShader).replace('#define CUSTOM_FRAGMENT_DEFINITIONS', '');
  const off = [...new Set([...own.matchAll(/#if ([A-Z_]+)/g)].map(m => m[1]))].map(name => `#define ${name} 0\n`).join(''); // as the engine reads what is not defined
  const theirs = '#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n#define varying in\n#define texture2D texture\nout vec4 shown;\n#define gl_FragColor shown\n' + off + own;
  const corner = '#version 300 es\nout vec2 vUV;\nvoid main() { vec2 p = vec2(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1); vUV = 0.5 * p + 0.5; gl_Position = vec4(p, 0.0, 1.0); }';
  const program = text => {
    const p = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, corner], [gl.FRAGMENT_SHADER, text]]) {
      const s = gl.createShader(type);
      gl.shaderSource(s, source);
      gl.compileShader(s);
      if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(s));
      gl.attachShader(p, s);
    }
    gl.linkProgram(p);
    if (!gl.getProgramParameter(p, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(p));
    return p;
  };
  const texture = (width, height, pixels, one) => {
    const t = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, t);
    gl.texImage2D(gl.TEXTURE_2D, 0, one ? gl.R32F : gl.RGBA32F, width, height, 0, one ? gl.RED : gl.RGBA, gl.FLOAT, pixels);
    for (const f of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, f, gl.NEAREST);
    for (const f of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, f, gl.CLAMP_TO_EDGE);
    return t;
  };
  const frame = gl.createFramebuffer();
  const run = (p, textures, uniforms, target, width, height) => {
    gl.useProgram(p);
    Object.entries(textures).forEach(([name, t], unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, t);
      gl.uniform1i(gl.getUniformLocation(p, name), unit);
    });
    for (const name in uniforms) {
      const v = uniforms[name], at = gl.getUniformLocation(p, name);
      if (typeof v === 'number') gl.uniform1f(at, v);
      else if (name === 'ms_sss') gl.uniform4fv(at, v);
      else if (name === 'diffusionS') gl.uniform3fv(at, v);
      else if (v.length === 2) gl.uniform2f(at, ...v);
      else gl.uniform1fv(at, v);
    }
    gl.bindFramebuffer(gl.FRAMEBUFFER, frame);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
    gl.viewport(0, 0, width, height);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  };
  const read = (width, height) => { const out = new Float32Array(4 * width * height); gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, out); return out; };
  return { gl, program, texture, run, read, theirs };
}
// A frame larger `by` times, for the timing; its textures, and what draws it.
function filters(b, core, t, by, taps) {
  const width = by * t.width, height = by * t.height, n = width * height, light = new Float32Array(4 * n), depth = new Float32Array(n);
  for (let y = 0, i = 0; y < height; ++y)
    for (let x = 0; x < width; ++x, ++i) {
      const j = Math.floor(y / by) * t.width + Math.floor(x / by);
      depth[i] = t.depth[j];
      for (let c = 0; c < 4; ++c) light[4 * i + c] = t.light[4 * j + c];
    }
  const tan = Math.tan(t.fov * Math.PI / 360), perMm = height / (2 * tan * t.nearest * t.mm);
  core.numbers(4 * t.count + 1).set(t.rings);
  core.check(core.wasm.rings(0, t.count, taps, perMm));
  const reflectance = Array.from(core.numbers().slice(1, 4)), constants = core.constants(taps, 1, width, height, t.fov, t.mm);
  const inputs = { irradianceSampler: b.texture(width, height, light), depthSampler: b.texture(width, height, depth, true), albedoSampler: b.texture(1, 1, new Float32Array([1, 1, 1, 1])) };
  const white = new Float32Array(4 * n).fill(1), albedo = b.texture(width, height, white), black = b.texture(width, height, new Float32Array(4 * n)), between = b.texture(width, height, null), out = b.texture(width, height, null);
  const widest = Math.max(...t.d), { config } = view.sss, sample = (u, d) => config._sampleBurleyDiffusionProfile(u, d), five = v => [...v, ...v, ...v, ...v, ...v];
  const programs = b.programs[taps] = b.programs[taps] || [0, 1].map(pass => b.program(BabylonSubsurface.text(pass, taps, 1)));
  b.own = b.own || b.program(b.theirs);
  return {
    width, height, reflectance,
    ours() {
      b.run(programs[0], { irradianceSampler: inputs.irradianceSampler, depthSampler: inputs.depthSampler }, { ms_sss: constants }, between, width, height);
      b.run(programs[1], { ...inputs, albedoSampler: albedo, colorSampler: black, textureSampler: between }, { ms_sss: constants }, out, width, height);
    },
    theirs(scale) {
      b.run(b.own, { ...inputs, textureSampler: black }, { texelSize: [1 / width, 1 / height], viewportSize: [tan * width / height, tan], metersPerUnit: scale * t.mm / 1000,
        'diffusionS': five(t.d.map(v => 1 / v)), 'diffusionD': five([widest]), 'filterRadii': five([sample(0.997, widest)]) }, out, width, height);
    },
  };
}
function errorOf(t, reflectance, picture) { // out: light, before the reflectance
  let difference = 0, all = 0;
  for (let i = 0; i < t.depth.length; ++i) {
    if (!(t.depth[i] > 0)) continue;
    for (let c = 0; c < 3; ++c) {
      const walk = t.walk[3 * i + c];
      difference += (reflectance[c] * picture[4 * i + c] - walk) ** 2;
      all += walk * walk;
    }
  }
  return 100 * Math.sqrt(difference / all);
}
function show(title, t, reflectance, picture, stride) {
  const left = Math.round(t.width * 0.28), side = t.height, c = make('canvas', { width: side, height: side }), paper = c.getContext('2d'), im = paper.createImageData(side, side);
  for (let y = 0; y < side; ++y)
    for (let x = 0; x < side; ++x)
      for (let k = 0; k < 4; ++k) {
        const i = y * t.width + x + left, v = t.depth[i] > 0 && k < 3 ? (stride === 3 ? 1 : reflectance[k]) * picture[stride * i + k] * (t.name === 'bust' ? 2.6 : 1.1) : 0;
        im.data[4 * (y * side + x) + k] = k === 3 ? 255 : 255 * Math.min(1, v) ** (1 / 2.2);
      }
  paper.putImageData(im, 0, 0);
  $('pictures').append(make('figure', {}, c, make('figcaption', { textContent: title })));
}
const TAPS = 7, texels = { none: 1, theirs: 2 * 40 + 2, ours: 4 * TAPS + 7 };
async function measure() {
  const core = await BabylonSubsurface.core(), b = bench(), result = { none: [], theirs: [], ours: [], scale: [] };
  b.programs = {};
  for (const name of ['bust', 'knot']) {
    const t = await truth(name), f = filters(b, core, t, 1, TAPS);
    f.ours();
    const ours = b.read(f.width, f.height);
    let best = null;
    for (let k = -8; k <= 12; ++k) { // Babylon's lengths, scaled: the least error
      const scale = 2 ** (k / 4);
      f.theirs(scale);
      const picture = b.read(f.width, f.height), error = errorOf(t, f.reflectance, picture);
      if (!best || error < best.error) best = { scale, error, picture };
    }
    result.none.push(errorOf(t, f.reflectance, t.light));
    result.ours.push(errorOf(t, f.reflectance, ours));
    result.theirs.push(best.error);
    result.scale.push(best.scale);
    for (const [title, p, stride] of [[`unfiltered, ${result.none.at(-1).toFixed(1)}%`, t.light, 4], [`Babylon.js, ${best.error.toFixed(1)}%`, best.picture, 4], [`ms_sss.h, ${result.ours.at(-1).toFixed(1)}%`, ours, 4], ['path-traced', t.walk, 3]]) show(title, t, f.reflectance, p, stride);
    if (name === 'bust') view.clock = { b, f: filters(b, core, t, option('by', 4), TAPS), scale: best.scale };
  }
  view.measured = result;
  const row = (name, key, time) => make('tr', {}, make('td', { textContent: name }), ...result[key].map(e => make('td', {}, make('b', { className: key === 'ours' ? 'best' : '', textContent: e.toFixed(1) + '%' }))), make('td', { textContent: texels[key] }), make('td', { id: 'time-' + key, textContent: time }));
  $('rows').replaceChildren(row('unfiltered', 'none', ''), row('Babylon.js, 40 samples', 'theirs', '…'), row('ms_sss.h, 7 taps in two passes', 'ours', '…'));
}
// Frames of both in turn, until some have been drawn; the medians. A read of one pixel waits for the graphics processor.
async function clock() {
  const { b, f, scale } = view.clock, pixel = new Float32Array(4), times = { theirs: [], ours: [] }, draws = option('draws', 8);
  const once = draw => {
    const from = performance.now();
    for (let k = 0; k < draws; ++k) draw();
    b.gl.readPixels(0, 0, 1, 1, b.gl.RGBA, b.gl.FLOAT, pixel);
    return (performance.now() - from) / draws;
  };
  for (let k = 0; k < 6; ++k) {
    for (const [name, draw] of [['theirs', () => f.theirs(scale)], ['ours', f.ours]]) { const ms = once(draw); if (k) times[name].push(ms); }
    await new Promise(r => setTimeout(r, 0));
  }
  const middle = v => v.sort((x, y) => x - y)[v.length >> 1], theirs = middle(times.theirs), ours = middle(times.ours);
  view.time = { theirs, ours, ratio: theirs / ours };
  for (const name of ['theirs', 'ours']) $('time-' + name).textContent = view.time[name].toFixed(2) + ' ms';
  const info = b.gl.getExtension('WEBGL_debug_renderer_info'), card = info ? b.gl.getParameter(info.UNMASKED_RENDERER_WEBGL) : 'this machine';
  $('timing').textContent = `Times: ${f.width} × ${f.height} of the head, medians of frames in turn, measured now on ${card}. Babylon's pass takes ${(theirs / ours).toFixed(2)} times ours.`;
}
$('again').onclick = () => clock().catch(refuse);

(async () => {
  $('message').textContent = 'Loading …';
  if (!window.DecompressionStream) throw new Error('This page wants a browser of 2023 or later: DecompressionStream is missing.');
  if (!document.createElement('canvas').getContext('webgl2')) throw new Error('This page wants WebGL 2, which this browser does not offer.');
  if (!window.BABYLON) throw new Error('Babylon.js 9.35 was not loaded: this page takes it from cdn.jsdelivr.net and wants the network. (It is 9 MB, too large to lie here.)');
  if (!window.BabylonSubsurface) throw new Error('sss_babylon.js does not lie beside this page.');
  const started = performance.now();
  await scene();
  view.sceneTook = performance.now() - started;
  $('message').hidden = true;
  await new Promise(r => setTimeout(r, 30));
  await measure();
  view.measureTook = performance.now() - started;
  await clock();
  view.ready = true;
})().catch(refuse);
