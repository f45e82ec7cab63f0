// The studio's page: what is seen and touched. All arithmetic is in two workers (studio.worker.js); nothing here takes longer than a frame.
const $ = id => document.getElementById(id), SIDE = 128, SHELF = 16, SPOTS = 9;
const make = (tag, props = {}, ...inside) => { const e = Object.assign(document.createElement(tag), props); e.append(...inside); return e; };

// --------------------------------------------------------------------------------------------------------------- workers
function worker(matches) {
  const source = $('wasi').textContent + $('worker').textContent;
  const w = new Worker(URL.createObjectURL(new Blob([source], { type: 'text/javascript' })));
  const waiting = new Map();
  let id = 0;
  w.onmessage = ({ data }) => {
    if (data.id === undefined) return void w.heard(data);
    const { yes, no } = waiting.get(data.id);
    waiting.delete(data.id);
    data.problem === undefined ? yes(data.result) : no(new Error(data.problem));
  };
  w.onerror = e => fail(e);
  w.ask = (call, args, moved = []) => new Promise((yes, no) => { waiting.set(++id, { yes, no }); w.postMessage({ id, call, args }, moved); });
  w.busy = () => waiting.size > 0;
  const networks = Object.fromEntries([...document.querySelectorAll('script[data-network]')].map(s => [s.dataset.network, s.textContent]));
  w.ready = w.ask('start', { binary: $('binary').textContent, networks, matches });
  return w;
}
const fail = e => { console.error(String(e && e.message || e)); $('says').textContent = 'Oh dear: ' + (e && e.message || e); };

// Only the newest call of a kind runs; those that came while it did are dropped but the last.
function latest(run) {
  let running = false, next = null;
  return async function go(...args) {
    if (running) return void (next = args);
    running = true;
    try { await run(...args); } catch (e) { fail(e); }
    running = false;
    if (next) { const a = next; next = null; go(...a); }
  };
}

// --------------------------------------------------------------------------------------------------- what materials look like
const show = (canvas, pixels, side = SIDE) => { canvas.getContext('2d', { willReadFrequently: true }).putImageData(new ImageData(pixels, side, side), 0, 0); return canvas; };
const ball = pixels => show(make('canvas', { className: 'ball', width: SIDE, height: SIDE }), pixels);
const shares = x => ({ diffuse: (1 - x[17]) * (1 - x[7]), metal: (1 - x[17]) * x[7], glass: x[17] * (1 - x[16]), jelly: x[17] * x[16] });
const colours = { diffuse: 0, metal: 3, glass: 8, jelly: 13 };
const shown = c => c.map(v => Math.round(255 * Math.pow(Math.min(Math.max(v, 0), 1), 1 / 2.2)));

// The colour that a picture shows where the ball faces the camera.
function seen(pixels) {
  const sum = [0, 0, 0];
  for (let y = 40; y < 88; y += 2) for (let x = 36; x < 92; x += 2) for (let c = 0; c < 3; ++c) sum[c] += pixels[4 * (y * SIDE + x) + c];
  return sum.map(v => v / (24 * 28 * 255));
}
function nameOf(x, pixels) {
  const s = shares(x), lobe = Object.keys(s).reduce((a, b) => s[b] > s[a] ? b : a), rough = lobe === 'metal' ? x[6] : x[11], c = seen(pixels);
  const most = Math.max(...c), spread = most - Math.min(...c);
  let hue = 0;
  if (spread > 0) hue = (most === c[0] ? (c[1] - c[2]) / spread + 6 : most === c[1] ? (c[2] - c[0]) / spread + 2 : (c[0] - c[1]) / spread + 4) % 6;
  const hues = ['cherry', 'coral', 'amber', 'honey', 'lemon', 'lime', 'leaf', 'emerald', 'mint', 'teal', 'sky', 'ocean', 'royal', 'indigo', 'violet', 'orchid', 'rose', 'ruby'];
  const tint = spread < 0.16 * Math.max(most, 0.15) ? (most > 0.66 ? 'snow' : most > 0.36 ? 'silver' : most > 0.16 ? 'smoky' : 'midnight')
    : most < 0.2 ? 'dark ' + hues[Math.floor(hue / 6 * 18)] : hues[Math.floor(hue / 6 * 18)];
  return tint + ' ' + { diffuse: x[17] > 0.35 ? 'porcelain' : x[7] > 0.3 ? 'enamel' : 'clay', metal: rough < 0.35 ? 'chrome' : rough < 0.7 ? 'metal' : 'satin',
    glass: x[17] < 0.6 ? 'lacquer' : rough < 0.35 ? 'glass' : rough < 0.7 ? 'misty glass' : 'frosted glass', jelly: x[18] > 0.6 ? 'wax' : s.glass > 0.25 ? 'jelly' : 'jade' }[lobe];
}
// A face from very sad (0) to delighted (1).
function face(v, sleeping) {
  const bend = 62 + (v - 0.5) * 34, corner = 62 - (v - 0.5) * 16, open = v > 0.86, hue = 18 + 32 * v, light = 62 + 6 * v, sat = 25 + 70 * v;
  const eye = v > 0.92 || sleeping ? x => `<path d="M${x - 8} 42q8 -11 16 0" fill="none" stroke="#3a2415" stroke-width="5" stroke-linecap="round"/>` : x => `<ellipse cx="${x}" cy="41" rx="5.5" ry="${6 + 2 * v}" fill="#3a2415"/>`;
  return `<svg viewBox="0 0 100 100" aria-hidden="true"><circle cx="50" cy="50" r="47" fill="hsl(${hue} ${sat}% ${light}%)"/><ellipse cx="36" cy="22" rx="17" ry="9" fill="#fff" opacity=".45" transform="rotate(-24 36 22)"/>${eye(33)}${eye(67)}` +
    (v > 0.6 ? `<circle cx="20" cy="58" r="8" fill="#f66" opacity="${(v - 0.6).toFixed(2)}"/><circle cx="80" cy="58" r="8" fill="#f66" opacity="${(v - 0.6).toFixed(2)}"/>` : '') +
    `<path d="M27 ${corner.toFixed(1)}Q50 ${(open ? bend + 22 : bend + (v - 0.5) * 16).toFixed(1)} 73 ${corner.toFixed(1)}${open ? 'Z' : ''}" fill="${open ? '#7a2a1c' : 'none'}" stroke="#3a2415" stroke-width="5" stroke-linecap="round" stroke-linejoin="round"/></svg>`;
}
const heat = v => `hsl(${18 + 28 * v} ${30 + 65 * v}% ${56 + 2 * v}%)`;

// A scale of eleven steps under a face that follows the pointer; done(score) when one is clicked.
function scale(done, now) {
  const f = make('span', { className: 'face', innerHTML: face(now === undefined ? 0.5 : now / 10) }), s = make('div', { className: 'scale', role: 'group' });
  const light = k => { [...s.children].forEach((b, i) => { b.classList.toggle('lit', i <= k); b.style.setProperty('--heat', heat(k / 10)); }); f.innerHTML = face(k < 0 ? 0.5 : k / 10); };
  for (let k = 0; k <= 10; ++k) {
    const b = make('button', { title: String(k), ariaLabel: `score ${k} of 10` });
    b.onpointerenter = b.onfocus = () => light(k);
    b.onclick = e => { e.stopPropagation(); light(k); done(k, b); };
    s.append(b);
  }
  s.onpointerleave = () => light(now === undefined ? -1 : now);
  if (now !== undefined) light(now);
  return make('div', { className: 'vote' }, f, s);
}
const heart = '<svg viewBox="0 0 24 24" width="22"><path fill="#f0563a" d="M12 21C5 15 2 12 2 8a5 5 0 0 1 10-1 5 5 0 0 1 10 1c0 4-3 7-10 13z"/></svg>', star = '<svg viewBox="0 0 24 24" width="22"><path fill="#ffb733" d="m12 1 3 8 8 .5-6.3 5 2 8L12 18l-6.7 4.5 2-8-6.3-5L9 9z"/></svg>';
function sparks(at, kinds) {
  if (matchMedia('(prefers-reduced-motion:reduce)').matches) return;
  const r = at.getBoundingClientRect();
  for (let k = 0; k < 9; ++k) {
    const e = make('span', { className: 'spark', innerHTML: kinds[k % kinds.length] });
    e.style.cssText = `left:${r.left + r.width * Math.random()}px;top:${r.top}px;--dx:${160 * Math.random() - 80}px;--turn:${120 * Math.random() - 60}deg;animation-delay:${70 * k}ms`;
    document.body.append(e);
    setTimeout(() => e.remove(), 1900);
  }
}

// ------------------------------------------------------------------------------------------------------------- the session
const studio = window.studio = { deck: [], scored: [], recommended: [], chosen: null, view: null, match: null, kept: [], settled: true, version: 0, answers: 0, longest: 0 };
// The longest that the page itself held a frame up, in ms; for whoever wants to know.
const timed = f => function (...a) {
  const t = performance.now();
  try { return f.apply(this, a); } finally {
    const spent = performance.now() - t;
    if (spent > studio.longest) { studio.longest = spent; studio.longestIn = String(f).slice(0, 60); }
  }
};
// Work that can wait, a few milliseconds of it a frame.
const pieces = [];
function piece(job) {
  if (pieces.push(timed(job)) > 1) return;
  const run = () => {
    const end = performance.now() + 3;
    do pieces[0](), pieces.shift(); while (pieces.length && performance.now() < end);
    if (pieces.length) requestAnimationFrame(run);
  };
  requestAnimationFrame(run);
}
let mind, hand, queue = [], filling = null, mode = 'score';
const deckSize = () => innerWidth < 620 ? 4 : 8;
studio.idle = () => studio.started && studio.settled && !mind.busy() && !hand.busy() && !filling && !pieces.length && studio.deck.length > 0;

studio.draw = async x => (await hand.ask('draw', { x })).map(p => Array.from(p)); // pictures of any materials, for scripts

async function fill() { // the queue of pictures not scored yet
  if (filling || queue.length > 6) return filling;
  filling = (async () => {
    const x = await mind.ask('gallery', { count: studio.scored.length ? 8 : 16 });
    for (let i = 0; i < x.length; i += 4) {
      const part = x.slice(i, i + 4), pictures = await hand.ask('draw', { x: part });
      part.forEach((one, k) => queue.push({ x: one, picture: pictures[k] }));
      deal();
    }
  })();
  try { await filling; } catch (e) { fail(e); studio.started = false; }
  filling = null;
  deal();
}

function deal() { // cards from the queue, one a piece
  const want = mode === 'pair' ? 2 : deckSize();
  for (const e of document.querySelectorAll('#deck .waiting')) if (queue.length) e.remove();
  while (studio.deck.length < want && queue.length) {
    const item = queue.shift();
    item.mode = mode;
    studio.deck.push(item);
    piece(() => lay(item));
  }
  if (queue.length < 5 && !filling && studio.started) fill();
}
function lay(item) {
  if (!studio.deck.includes(item)) return;
  const deck = $('deck'), card = make('div', { className: 'card' }, ball(item.picture), make('div', { className: 'name', textContent: nameOf(item.x, item.picture) }));
  item.card = card;
  card.dataset.x = item.x.map(v => v.toFixed(5)).join();
  if (item.mode === 'pair') card.onclick = () => prefer(item);
  else card.append(scale((k, b) => answer(item, k, b)));
  const slot = mode === item.mode ? slots.shift() : null; // a new one takes the place of one that left
  if (slot && slot.parentNode) slot.replaceWith(card); else deck.insertBefore(card, deck.querySelector('.pair-bar'));
}

const slots = [];
function leave(item) {
  studio.deck.splice(studio.deck.indexOf(item), 1);
  item.card.classList.add('gone');
  slots.push(item.card);
  setTimeout(deal, 230);
}

// An answer on its way to the mind, and how the page takes it back.
const done = [];
function says(call, args, back) {
  ++studio.answers;
  studio.settled = false;
  if (back) done.push(back);
  $('undo').disabled = done.length === 0;
  const told = mind.ask(call, args);
  told.catch(fail);
  return told;
}
const answer = timed((item, score, at) => {
  if (!studio.deck.includes(item) || item.card.classList.contains('gone')) return;
  if (score >= 9) sparks(at, [heart, star]);
  const s = { x: item.x, score, picture: item.picture };
  studio.scored.push(s);
  s.row = says('score', { x: item.x, score }, () => { studio.scored.pop(); again(s); });
  leave(item);
  piece(() => remember(s));
  tell();
});

function remember(s) {
  if (s.gone) return;
  s.button = make('button', { className: 'was', ariaLabel: `${nameOf(s.x, s.picture)}: ${s.score}` }, ball(s.picture), make('b', { textContent: s.score }));
  if (s.row) s.button.onclick = () => rethink(s);
  $('history').prepend(s.button);
}
// What was taken back is shown again.
function again(...items) {
  for (const s of items) {
    s.gone = true;
    if (s.button) s.button.remove();
  }
  for (const item of studio.deck.splice(studio.deck.length - items.length)) { if (item.card) item.card.remove(); queue.unshift(item); }
  for (const s of items) queue.unshift({ x: s.x, picture: s.picture });
  deal();
}
function rethink(s) {
  const d = make('dialog'), mark = score => { s.score = score; s.button.querySelector('b').textContent = score; };
  d.append(ball(s.picture), scale(async k => {
    const old = s.score;
    mark(k);
    d.close();
    says('rescore', { index: await s.row, score: k }, () => mark(old));
  }, s.score));
  d.onclose = () => d.remove();
  d.onclick = e => { if (e.target === d) d.close(); };
  document.body.append(d);
  d.showModal();
}
$('undo').onclick = timed(() => {
  const back = done.pop();
  says('undo');
  back();
  tell();
});

// --------------------------------------------------------------------------------------------------------- recommendations
let restock;
function heard({ learned, settled, state, problem }) {
  if (problem) return fail(problem);
  if (learned !== studio.answers && settled) return; // more is under way
  if (state >= 2) restock(settled);
  if (settled && !(state >= 2)) studio.settled = true;
}
const names = { diffuse: 'matt', metal: 'metal', glass: 'glass', jelly: 'translucent' };
restock = latest(async settled => {
  try {
    const found = await mind.ask('recommend', { count: SHELF });
    const pictures = await hand.ask('draw', { x: found.map(f => f.x) });
    found.forEach((f, k) => { f.picture = pictures[k]; });
    stock(found);
  } catch (e) {
    studio.recommended = [];
    $('shelf').replaceChildren();
    $('advice').textContent = done.length < 8 ? 'Keep going: nothing to go by yet.' : 'Nothing that you like so far. Score something a little higher, and I will find its friends.';
  }
  if (settled) studio.settled = true;
  tell();
});
function stock(found) { // the shelf's buttons stay, their pictures change one after the other
  studio.recommended = found;
  const shelf = $('shelf'), top = best(), version = ++studio.version;
  found.forEach((f, k) => piece(() => {
    if (version !== studio.version) return;
    let b = shelf.children[k];
    if (!b) {
      b = make('button', { className: 'pick' }, make('canvas', { className: 'ball', width: SIDE, height: SIDE }), make('span', { className: 'face' }));
      b.onclick = () => { shelf.querySelectorAll('.chosen').forEach(e => e.classList.remove('chosen')); b.classList.add('chosen'); choose(b.material); };
      shelf.append(b);
    }
    b.material = f.x;
    b.dataset.x = f.x.map(v => v.toFixed(5)).join();
    b.classList.remove('chosen');
    b.title = b.ariaLabel = studio.scored.length ? `${nameOf(f.x, f.picture)}: about ${f.mean.toFixed(1)} ± ${f.sigma.toFixed(1)}` : nameOf(f.x, f.picture);
    show(b.firstChild, f.picture);
    b.firstChild.getAnimations().forEach(a => { a.cancel(); a.play(); });
    b.lastChild.innerHTML = face(Math.min(Math.max(f.mean / top, 0), 1));
  }));
  $('advice').textContent = 'Click one to walk around it.';
  $('more').disabled = false;
}
$('more').onclick = () => restock(false);

// What a delighted face stands for: without scores predictions have a scale of their own.
const best = () => studio.scored.length ? Math.max(10, ...studio.scored.map(s => s.score)) : Math.max(1e-3, ...studio.recommended.map(r => r.mean));
function tell() {
  const n = done.length, r = studio.recommended, mean = r.length ? r.reduce((s, f) => s + f.mean, 0) / r.length / best() : 0.5;
  $('mood').innerHTML = face(n ? Math.min(Math.max(r.length ? mean : 0.35, 0), 1) : 0.7);
  const lobes = { diffuse: 0, metal: 0, glass: 0, jelly: 0 };
  r.forEach(f => { const s = shares(f.x); for (const k in s) lobes[k] += s[k] / r.length; });
  const top = Object.keys(lobes).sort((a, b) => lobes[b] - lobes[a]);
  $('says').textContent = n === 0 ? 'Tell me what you like. I learn while you click.'
    : r.length === 0 ? `${n} ${n === 1 ? 'answer' : 'answers'}, and I am curious …`
    : n < 10 ? `${n} answers. A hunch: ${names[top[0]]}?` : `${n} answers. You seem to like ${names[top[0]]}${lobes[top[1]] > 0.28 ? ' and ' + names[top[1]] : ''}.`;
}

// --------------------------------------------------------------------------------------------------------------- the plane
let land = null;
const choose = timed(async x => {
  studio.chosen = x;
  try {
    const plane = await mind.ask('choose', { x });
    land = { ...plane, spots: [], base: show(make('canvas', { width: 192, height: 192 }), plane.ground, 192) };
    $('plane-hint').hidden = true;
    studio.plane = land;
    walk(land.at);
    const [x0, x1, y0, y1] = land.window, points = [];
    for (let j = 0; j < SPOTS; ++j) for (let i = 0; i < SPOTS; ++i) points.push(x0 + (x1 - x0) * (i + 0.5) / SPOTS, y1 - (y1 - y0) * (j + 0.5) / SPOTS);
    const mine = land, seen = await mind.ask('look', { points }), widest = Math.max(...seen.variance, 1e-9);
    for (let k = 0; k < seen.x.length && land === mine; k += SPOTS) {
      const pictures = await hand.ask('draw', { x: seen.x.slice(k, k + SPOTS) });
      pictures.forEach((p, i) => piece(() => { mine.spots[k + i] = { picture: thumb(p), sure: 1 - seen.variance[k + i] / widest, at: points.slice(2 * (k + i), 2 * (k + i) + 2) }; }));
      piece(() => { if (land === mine) draw(); });
    }
  } catch (e) {
    $('plane-hint').hidden = !!land;
    $('plane-hint').textContent = String(e.message);
  }
});
function thumb(pixels) { // the ball alone, on a round piece
  const c = make('canvas', { width: 64, height: 64 }), g = c.getContext('2d');
  g.beginPath();
  g.arc(32, 32, 31, 0, 7);
  g.clip();
  g.drawImage(show(make('canvas', { width: SIDE, height: SIDE }), pixels), 13, 8, 102, 102, 0, 0, 64, 64);
  return c;
}
const draw = timed(() => {
  const c = $('plane'), g = c.getContext('2d'), w = c.width, [x0, x1, y0, y1] = land.window;
  const px = x => (x - x0) / (x1 - x0) * w, py = y => (y1 - y) / (y1 - y0) * w;
  g.imageSmoothingEnabled = true;
  g.clearRect(0, 0, w, w);
  g.globalAlpha = 0.75;
  g.drawImage(land.base, 0, 0, w, w);
  for (const s of land.spots) {
    if (!s || s.sure < 0.12) continue;
    const r = w / SPOTS * (0.2 + 0.28 * s.sure);
    g.globalAlpha = Math.min(1, 0.3 + 1.2 * s.sure);
    g.drawImage(s.picture, px(s.at[0]) - r, py(s.at[1]) - r, 2 * r, 2 * r);
  }
  g.globalAlpha = 1;
  for (let i = 0; i < land.points.length; i += 2) {
    g.beginPath();
    g.arc(px(land.points[i]), py(land.points[i + 1]), 5, 0, 7);
    g.fillStyle = '#fff';
    g.fill();
    g.strokeStyle = '#0006';
    g.lineWidth = 1;
    g.stroke();
  }
  const [x, y] = [px(land.at[0]), py(land.at[1])];
  g.beginPath();
  g.arc(x, y, 17, 0, 7);
  g.fillStyle = '#ff6a4a';
  g.fill();
  g.strokeStyle = '#fff';
  g.lineWidth = 4;
  g.stroke();
  g.fillStyle = '#fff';
  for (const d of [-6, 6]) { g.beginPath(); g.arc(x + d, y - 3, 2.6, 0, 7); g.fill(); }
  g.beginPath();
  g.arc(x, y + 1, 7, 0.3, 2.84);
  g.lineWidth = 3;
  g.stroke();
});
const step = latest(async to => {
  const v = await mind.ask('move', { to });
  look(v);
});
const look = timed(v => {
  studio.view = { x: v.x, score: v.score, sigma: v.sigma, picture: v.picture };
  show($('here'), v.picture);
  const s = shares(v.x);
  $('here-face').innerHTML = face(Math.min(Math.max(v.score / best(), 0), 1));
  $('here-name').textContent = nameOf(v.x, v.picture);
  $('where').textContent = studio.scored.length ? `I guess ${Math.max(v.score, 0).toFixed(1)} ± ${v.sigma.toFixed(1)}` : v.score > 0.8 * best() ? 'I think that you love it' : v.score > 0.5 * best() ? 'I think that you like it' : v.score > 0.2 * best() ? 'I am not sure about it' : 'I doubt that you like it';
  $('here-mix').replaceChildren(...Object.keys(s).map(k => {
    const e = make('i', { title: `${names[k]} ${Math.round(100 * s[k])}%` });
    e.style.cssText = `width:${100 * s[k]}%;background:rgb(${shown(v.x.slice(colours[k], colours[k] + 3))})`;
    return e;
  }));
  for (const id of ['keep', 'brush', 'like', 'avoid']) $(id).disabled = false;
  if (!easel.dirty) begin(v.x, v.picture);
});
function walk(to) {
  const [x0, x1, y0, y1] = land.window;
  land.at = [Math.min(Math.max(to[0], x0), x1), Math.min(Math.max(to[1], y0), y1)];
  draw();
  step(land.at);
}
{
  const c = $('plane'), to = e => {
    const r = c.getBoundingClientRect(), [x0, x1, y0, y1] = land.window;
    walk([x0 + (x1 - x0) * (e.clientX - r.left) / r.width, y1 - (y1 - y0) * (e.clientY - r.top) / r.height]);
  };
  c.onpointerdown = e => { if (land) { c.setPointerCapture(e.pointerId); to(e); } };
  c.onpointermove = e => { if (land && e.buttons) to(e); };
  c.onkeydown = e => {
    const d = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[e.key];
    if (!d || !land) return;
    e.preventDefault();
    const s = (land.window[1] - land.window[0]) / 40;
    walk([land.at[0] + s * d[0], land.at[1] + s * d[1]]);
  };
}

// ------------------------------------------------------------------------------------------------------------- the easel
const easel = { x: null, dirty: false, colour: '#e8502a' };
const sliders = ['saturation', 'hue', 'light', 'tint'];
function begin(x, picture) {
  easel.x = x;
  easel.dirty = false;
  for (const s of sliders) $(s).value = s === 'saturation' ? 1 : 0;
  $('strokes').getContext('2d').clearRect(0, 0, SIDE, SIDE);
  show($('easel'), picture);
  show($('matched'), picture);
  studio.match = null;
  $('adopt').disabled = $('keep-match').disabled = true;
  $('found').textContent = 'the material that looks like it';
}
const repaint = latest(async () => {
  if (!easel.x) return;
  const value = s => Number($(s).value), c = easel.colour.match(/\w\w/g).map(h => parseInt(h, 16) / 255), from = easel.x;
  const strokes = $('strokes').getContext('2d').getImageData(0, 0, SIDE, SIDE).data;
  const edit = { saturation: value('saturation'), hue: value('hue'), light: value('light'), tint: value('tint'), colour: c };
  const { picture } = await hand.ask('paint', { x: from, edit, strokes }, [strokes.buffer]);
  if (from !== easel.x) return;
  show($('easel'), picture);
  for (const cost of [0, 60]) { // a first answer at once, a better one after it
    const m = await hand.ask('match', { x: from, cost });
    if (from !== easel.x) return;
    compare(m);
  }
});
const compare = timed(m => {
  studio.match = m;
  show($('matched'), m.picture);
  $('found').textContent = `${nameOf(m.x, m.picture)}, ${(100 * m.rmse).toFixed(1)}% away`;
  $('adopt').disabled = $('keep-match').disabled = false;
});
function change() { if (easel.x) { easel.dirty = true; repaint(); } }
for (const s of sliders) $(s).oninput = change;
for (const c of ['#e8502a', '#f2b134', '#f6e7c1', '#5fae57', '#2a9d8f', '#2f7de1', '#7b4fd0', '#e05a9c', '#ffffff', '#22211f']) {
  const b = make('button', { title: c, ariaLabel: 'colour ' + c, ariaPressed: String(c === easel.colour) });
  b.style.setProperty('--c', c);
  b.onclick = () => { easel.colour = c; for (const o of $('colours').children) o.ariaPressed = String(o === b); if (Number($('tint').value) > 0) change(); };
  $('colours').append(b);
}
{
  const c = document.querySelector('.easel'), g = $('strokes').getContext('2d', { willReadFrequently: true }), tip = $('tip');
  let last = null;
  const at = e => { const r = c.getBoundingClientRect(); return [(e.clientX - r.left) / r.width * SIDE, (e.clientY - r.top) / r.height * SIDE]; };
  const dab = timed((from, to) => { // soft dabs along the way
    const size = Number($('size').value), n = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / (size / 5)));
    for (let k = 1; k <= n; ++k) {
      const x = from[0] + (to[0] - from[0]) * k / n, y = from[1] + (to[1] - from[1]) * k / n, soft = g.createRadialGradient(x, y, 0, x, y, size);
      soft.addColorStop(0, easel.colour + '55');
      soft.addColorStop(0.5, easel.colour + '33');
      soft.addColorStop(1, easel.colour + '00');
      g.fillStyle = soft;
      g.fillRect(x - size, y - size, 2 * size, 2 * size);
    }
    change();
  });
  c.onpointerdown = e => { if (!easel.x) return; e.preventDefault(); c.setPointerCapture(e.pointerId); last = at(e); dab(last, last); };
  c.onpointermove = e => {
    const p = at(e), r = c.getBoundingClientRect().width * Number($('size').value) / SIDE;
    tip.style.cssText = `display:block;left:${100 * p[0] / SIDE}%;top:${100 * p[1] / SIDE}%;width:${1.4 * r}px;height:${1.4 * r}px`;
    if (last && e.buttons) { dab(last, p); last = p; }
  };
  c.onpointerup = c.onpointercancel = () => { last = null; };
  c.onpointerleave = () => { tip.style.display = 'none'; };
}
$('wipe').onclick = () => { if (studio.view) begin(studio.view.x, studio.view.picture); };
$('brush').onclick = () => { begin(studio.view.x, studio.view.picture); $('lab').scrollIntoView({ behavior: 'smooth', block: 'center' }); };
$('like').onclick = e => { sparks(e.target, [heart]); says('like', { x: studio.view.x }, () => {}); tell(); };
$('avoid').onclick = () => { says('avoid', { x: studio.view.x }, () => {}); tell(); };
$('adopt').onclick = () => { if (studio.match) { easel.dirty = false; choose(studio.match.x); $('walk').scrollIntoView({ behavior: 'smooth', block: 'center' }); } };

// --------------------------------------------------------------------------------------------------------- the collection
function keep(x, picture, at) {
  const item = { x, name: nameOf(x, picture) }, drop = make('button', { textContent: '×', ariaLabel: 'remove' });
  const e = make('div', { className: 'kept card' }, ball(picture), make('span', { textContent: item.name }), drop);
  drop.onclick = () => { studio.kept.splice(studio.kept.indexOf(item), 1); e.remove(); count(); };
  studio.kept.push(item);
  $('basket').append(e);
  sparks(at, [star]);
  count();
}
function count() {
  $('empty').hidden = studio.kept.length > 0;
  $('csv').disabled = $('mtlx').disabled = studio.kept.length === 0;
}
$('keep').onclick = e => keep(studio.view.x, studio.view.picture, e.target);
$('keep-match').onclick = e => keep(studio.match.x, studio.match.picture, e.target);
async function save(kind, type) {
  const seen = {}, names = studio.kept.map(k => { const n = k.name.replace(/\W/g, '_'); seen[n] = (seen[n] || 0) + 1; return seen[n] > 1 ? n + '_' + seen[n] : n; });
  const files = await mind.ask('save', { x: studio.kept.map(k => k.x), names });
  const link = make('a', { href: URL.createObjectURL(new Blob([files[kind]], { type })), download: 'materials.' + kind });
  studio.saved = new TextDecoder().decode(files[kind]);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
$('csv').onclick = () => save('csv', 'text/csv').catch(fail);
$('mtlx').onclick = () => save('mtlx', 'application/xml').catch(fail);

// -------------------------------------------------------------------------------------------------------------- this or that
const prefer = timed(item => {
  const other = studio.deck.find(o => o !== item);
  if (!other || !studio.deck.includes(item)) return;
  const s = { x: item.x, score: '♥', picture: item.picture }, t = { x: other.x, picture: other.picture };
  sparks(item.card, [heart]);
  says('better', { x: [item.x, other.x] }, () => again(s, t));
  leave(other);
  leave(item);
  piece(() => remember(s));
  tell();
});
const neither = timed(() => {
  if (studio.deck.length < 2) return;
  const pair = studio.deck.slice(), s = pair.map(o => ({ x: o.x, score: '–', picture: o.picture }));
  says('neither', { x: pair.map(o => o.x) }, () => again(...s));
  pair.forEach(leave);
  s.forEach(one => piece(() => remember(one)));
  tell();
});
function answerBy(next) {
  if (next === mode) return;
  mode = next;
  for (const [id, m] of [['by-score', 'score'], ['by-pair', 'pair']]) $(id).ariaPressed = String(m === mode);
  queue = [...studio.deck.map(({ x, picture }) => ({ x, picture })), ...queue];
  studio.deck.length = slots.length = 0;
  $('deck').replaceChildren();
  $('deck').className = mode;
  if (mode === 'pair') {
    const b = make('button', { className: 'quiet', id: 'neither', textContent: 'Neither' });
    b.onclick = neither;
    $('deck').append(make('div', { className: 'pair-bar' }, b));
  }
  deal();
}
$('by-score').onclick = () => answerBy('score');
$('by-pair').onclick = () => answerBy('pair');

// ------------------------------------------------------------------------------------------------------------------- begin
(async () => {
  tell();
  $('says').textContent = 'Waking up …';
  for (let k = 0; k < deckSize(); ++k) $('deck').append(make('div', { className: 'card waiting sleep' }, make('canvas', { className: 'ball', width: 8, height: 8 }), make('div', { className: 'name', textContent: ' ' })));
  await new Promise(r => setTimeout(r, 30)); // this much is seen before the networks are unpacked
  mind = worker(false);
  hand = worker(true);
  mind.heard = heard;
  await Promise.all([mind.ready, hand.ready]);
  studio.started = true;
  tell();
  fill();
})().catch(fail);
