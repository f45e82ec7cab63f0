// The studio's page: what is seen and touched. All arithmetic is in two workers (studio.worker.js); nothing here takes longer than a frame.
const $ = id => document.getElementById(id), M = 19, SIDE = 128, SHELF = 16, SPOTS = 9, UNDO = 64;
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
  async function go(...args) {
    if (running) return void (next = args);
    running = true;
    try { await run(...args); } catch (e) { fail(e); }
    running = false;
    if (next) { const a = next; next = null; go(...a); }
  }
  go.busy = () => running;
  return go;
}

// --------------------------------------------------------------------------------------------------- what materials look like
const show = (canvas, pixels, side = SIDE) => { canvas.getContext('2d', { willReadFrequently: true }).putImageData(new ImageData(pixels, side, side), 0, 0); return canvas; };
const ball = pixels => show(make('canvas', { className: 'ball', width: SIDE, height: SIDE }), pixels);
const shares = x => ({ diffuse: (1 - x[17]) * (1 - x[7]), metal: (1 - x[17]) * x[7], glass: x[17] * (1 - x[16]), jelly: x[17] * x[16] });
const colors = { diffuse: 0, metal: 3, glass: 8, jelly: 13 };
const shown = c => c.map(v => Math.round(255 * Math.pow(Math.min(Math.max(v, 0), 1), 1 / 2.2)));

// The color that a picture shows where the ball faces the camera.
function seen(pixels) {
  const sum = [0, 0, 0];
  for (let y = 40; y < 88; y += 2) for (let x = 36; x < 92; x += 2) for (let c = 0; c < 3; ++c) sum[c] += pixels[4 * (y * SIDE + x) + c];
  return sum.map(v => v / (24 * 28 * 255));
}
// The name whose hue, in degrees, is the nearest on the circle: those of the colors that are called so.
const hues = { coral: 16, honey: 37, amber: 46, lemon: 57, lime: 75, leaf: 115, emerald: 140, mint: 158, teal: 180, sky: 196, ocean: 208, royal: 226, violet: 270, orchid: 302, rose: 328, ruby: 338, cherry: 350 };
const hueName = degrees => Object.keys(hues).reduce((a, b) => {
  const away = name => Math.abs((degrees - hues[name] + 540) % 360 - 180);
  return away(b) < away(a) ? b : a;
});
function nameOf(x, pixels) {
  const s = shares(x), lobe = Object.keys(s).reduce((a, b) => s[b] > s[a] ? b : a), rough = lobe === 'metal' ? x[6] : x[11], c = seen(pixels);
  const most = Math.max(...c), spread = most - Math.min(...c);
  let hue = 0;
  if (spread > 0) hue = (most === c[0] ? (c[1] - c[2]) / spread + 6 : most === c[1] ? (c[2] - c[0]) / spread + 2 : (c[0] - c[1]) / spread + 4) % 6;
  const tint = spread < 0.16 * Math.max(most, 0.15) ? (most > 0.78 ? 'snow' : most > 0.36 ? 'silver' : most > 0.16 ? 'smoky' : 'midnight')
    : hue > 0.2 && hue < 0.8 && most < 0.6 ? 'cocoa' : (most < 0.2 ? 'dark ' : '') + hueName(60 * hue); // dark orange is brown
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

// A slider of eleven steps beside a face that follows it. done(score) is called when the pointer is released, or on Enter.
function scale(done, label, now = -1) {
  const f = make('span', { className: 'face' }), number = make('b'), s = make('div', { className: 'scale', role: 'slider', tabIndex: 0, ariaLabel: label, ariaValueMin: 0, ariaValueMax: 10 });
  let at = now, held = false;
  for (let k = 0; k <= 10; ++k) s.append(make('i'));
  const light = k => {
    at = k;
    [...s.children].forEach((b, i) => { b.classList.toggle('lit', i <= k); b.style.setProperty('--heat', heat(k / 10)); });
    s.ariaValueNow = k < 0 ? 5 : k;
    s.ariaValueText = k < 0 ? 'no score yet' : `${k} of 10`;
    f.innerHTML = face(k < 0 ? 0.5 : k / 10);
    number.textContent = k < 0 ? '' : k;
  };
  const under = e => { const r = s.getBoundingClientRect(); return Math.min(Math.max(Math.floor((e.clientX - r.left) / r.width * 11), 0), 10); };
  s.onpointerdown = e => { if (e.button === 0) { s.setPointerCapture(e.pointerId); held = true; light(under(e)); } };
  s.onpointermove = e => { if (held || e.pointerType === 'mouse') light(under(e)); };
  s.onpointerup = () => { if (held) { held = false; done(at); } };
  s.onpointercancel = s.onpointerleave = s.onblur = e => { if (e.type === 'pointercancel') held = false; if (!held) light(now); }; // a finger that scrolls scores nothing
  s.onkeydown = e => {
    const d = { ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1, Home: -10, End: 10 }[e.key];
    if (d) light(Math.min(Math.max((at < 0 ? 5 : at) + d, 0), 10));
    else if ((e.key === 'Enter' || e.key === ' ') && at >= 0) done(at);
    else return;
    e.preventDefault();
  };
  light(now);
  return Object.assign(make('div', { className: 'vote' }, make('div', { className: 'mood' }, f, number), s), { score: k => { light(k); done(k); } });
}
// One tab stop for a row of buttons: arrow keys go from one to the next.
const one = row => [...row.children].forEach((b, k) => { b.tabIndex = k ? -1 : 0; });
function rove(row) {
  row.addEventListener('focusin', e => { if (e.target !== row) for (const b of row.children) b.tabIndex = b === e.target ? 0 : -1; });
  row.addEventListener('keydown', e => {
    const d = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[e.key], all = [...row.children], next = all[all.indexOf(document.activeElement) + d];
    if (next) { e.preventDefault(); next.focus(); }
  });
}
for (const id of ['history', 'shelf', 'colors']) rove($(id));
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
const studio = window.studio = { shelved: '', guessed: 0, unsupported: '', deck: [], scored: [], recommended: [], chosen: null, view: null, match: null, kept: [], settled: true, version: 0, answers: 0, longest: 0, journal: [] };
const journal = studio.journal, within = v => studio.scored.length ? Math.min(Math.max(v, 0), 10) : v; // predictions on the scale of the scores
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
let mind, hand, queue = [], filling = null, mode = 'pair', byHand = false; // byHand: somebody chose how to answer
const deckSize = () => mode === 'pair' ? 2 : innerWidth < 720 ? 4 : 8;
studio.idle = () => studio.started && studio.settled && !mind.busy() && !hand.busy() && !restock.busy() && !filling && !pieces.length && studio.deck.length > 0;

studio.draw = async x => (await hand.ask('draw', { x })).map(p => Array.from(p)); // pictures of any materials, for scripts

async function fill() { // the queue of pictures not scored yet
  if (filling || queue.length > 6) return filling;
  filling = (async () => {
    const x = await mind.ask('gallery', { count: studio.answers ? 8 : 16 });
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
  const want = deckSize();
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
  if (item.mode === 'pair') {
    Object.assign(card, { tabIndex: 0, role: 'button', ariaLabel: nameOf(item.x, item.picture), onclick: () => prefer(item) });
    card.onkeydown = e => { if (e.key === 'Enter' || e.key === ' ') { e.preventDefault(); prefer(item); } };
  } else card.append(scale(k => answer(item, k), 'score of ' + nameOf(item.x, item.picture)));
  // A new card takes the place of one that left, or of one that waits: no other card moves.
  const slot = slots.shift() || deck.querySelector('.waiting');
  if (slot) slot.replaceWith(card); else deck.insertBefore(card, deck.querySelector('.pair-bar'));
  if (studio.deck.length >= deckSize() && studio.deck.every(o => o.card)) deck.querySelectorAll('.waiting').forEach(e => e.remove());
  if (document.activeElement === deck) attend(card);
}
const attend = card => (card.querySelector('.scale') || card).focus({ preventScroll: true });
const live = () => [...document.querySelectorAll('#deck .card:not(.gone):not(.waiting)')];

const slots = []; // cards that left, in whose places the next ones come
function withdraw(items) { // cards that go back to the head of the queue, in their order
  for (const item of items.reverse()) {
    if (item.card) { item.card.classList.add('gone'); slots.unshift(item.card); }
    queue.unshift({ x: item.x, picture: item.picture });
  }
}
function leave(item) {
  const cards = live(), k = cards.indexOf(item.card), next = cards[k + 1] || cards[k - 1];
  studio.deck.splice(studio.deck.indexOf(item), 1);
  if (item.card.contains(document.activeElement)) next ? attend(next) : $('deck').focus({ preventScroll: true }); // the focus stays in the deck
  item.card.classList.add('gone');
  slots.push(item.card);
  setTimeout(deal, 230);
}

// What an answer leaves in the history, e.shown, and how it is taken back.
function accept(e, pictures = []) {
  const { call, args } = e;
  e.shown = call === 'score' ? [{ id: e.id, score: args.score }] : call === 'better' ? [{ score: '♥' }, {}] : call === 'neither' ? args.x.map(() => ({ score: '–' })) : [];
  e.shown.forEach((s, k) => { s.x = call === 'score' ? args.x : args.x[k]; s.picture = pictures[k]; });
  e.back = () => again(...e.shown);
  if (call === 'score') {
    studio.scored.push(e.shown[0]);
    e.back = () => { studio.scored.splice(studio.scored.indexOf(e.shown[0]), 1); again(e.shown[0]); };
  } else if (call === 'rescore') {
    const s = studio.scored.find(s => s.id === args.of), old = s && s.score, mark = v => { s.score = v; if (s.button) s.button.querySelector('b').textContent = v; };
    e.back = () => { if (s) mark(old); };
    if (s) mark(args.score);
  }
  if (pictures.length) e.shown.forEach(s => piece(() => remember(s)));
}
// An answer on its way to the mind.
let undos = 0;
function says(call, args, pictures) {
  const e = { id: fresh(), call, args };
  accept(e, pictures);
  journal.push(e);
  store();
  undos = Math.min(undos + 1, UNDO);
  told(mind.ask(call, { ...args, id: e.id }), 1).catch(problem => { refused(e); fail(problem); });
}
function told(answer, count) {
  studio.answers += count;
  studio.settled = false;
  buttons();
  return answer;
}
function refused(e) {
  journal.splice(journal.indexOf(e), 1);
  undos = Math.max(undos - 1, 0);
  e.back();
  store();
  buttons();
}
function buttons() {
  $('undo').disabled = undos === 0;
  $('save').disabled = journal.length === 0;
  $('anew').disabled = journal.length === 0 && studio.kept.length === 0;
}
const answer = timed((item, score) => {
  if (!studio.deck.includes(item) || item.card.classList.contains('gone')) return;
  if (score >= 9) sparks(item.card.querySelector('.scale'), [heart, star]);
  says('score', { x: item.x, score }, [item.picture]);
  leave(item);
  tell();
});

function remember(s) {
  if (s.gone || s.score === undefined) return;
  s.button = make('button', { className: 'was', ariaLabel: `${nameOf(s.x, s.picture)}: ${s.score}` }, ball(s.picture), make('b', { textContent: s.score }));
  if (s.id) s.button.onclick = () => rethink(s);
  $('history').prepend(s.button);
  one($('history'));
}
// What was taken back is shown again.
async function again(...items) {
  for (const s of items) {
    s.gone = true;
    if (s.button) s.button.remove();
    if (!s.picture) [s.picture] = await hand.ask('draw', { x: [s.x] });
  }
  withdraw(studio.deck.splice(Math.max(studio.deck.length - items.length, 0), items.length));
  for (const s of items) queue.unshift({ x: s.x, picture: s.picture });
  one($('history'));
  deal();
}
function rethink(s) {
  const d = make('dialog', { ariaLabel: nameOf(s.x, s.picture) });
  d.append(ball(s.picture), scale(score => {
    d.close();
    if (score !== s.score) says('rescore', { of: s.id, score });
  }, 'another score', s.score));
  d.onclose = () => { d.remove(); s.button.focus({ preventScroll: true }); };
  d.onclick = e => { if (e.target === d) d.close(); };
  document.body.append(d);
  d.showModal();
}
$('undo').onclick = timed(() => {
  const e = journal.pop();
  gone.add(e.id);
  --undos;
  store();
  told(mind.ask('undo'), 1).catch(fail);
  e.back();
  buttons();
  if ($('undo').disabled) $('deck').focus({ preventScroll: true });
  tell();
});
document.addEventListener('keydown', e => { // digits score, + is ten; of a pair 1 and 2 are the better one, 0 is neither
  const at = document.activeElement, k = e.key === '+' ? 10 : /^\d$/.test(e.key) ? Number(e.key) : -1;
  if (k < 0 || e.ctrlKey || e.altKey || e.metaKey || e.repeat) return;
  const open = document.querySelector('dialog[open] .vote');
  if (!open && at !== document.body && !$('taste').contains(at)) return;
  const cards = live(), mine = cards.find(c => c.contains(at)) || cards.find(c => c.matches(':hover')) || cards[0];
  if (!open && mode === 'pair') { if (k === 0) neither(); else if (k <= 2 && cards[k - 1]) cards[k - 1].click(); }
  else if (open || mine) (open || mine.querySelector('.vote')).score(k);
  else return;
  e.preventDefault();
});

// ------------------------------------------------------------------------------------------------ what the browser keeps
// The journal of answers and the collection are written to localStorage at each change. Every answer has an id: two tabs take in what
// the other one wrote, each id once, and what was taken back in one of them does not return.
const STORE = 'ms-studio', gone = new Set(), fresh = () => Date.now().toString(36) + Math.random().toString(36).slice(2, 10);
let stored = true, changed = false;
const unit = x => Array.isArray(x) && x.length === M && x.every(v => typeof v === 'number' && v >= 0 && v <= 1);
const score = v => typeof v === 'number' && v >= 0 && v <= 10;
const sound = new Map(Object.entries({
  score: a => unit(a.x) && score(a.score),
  rescore: a => typeof a.of === 'string' && score(a.score),
  better: a => Array.isArray(a.x) && a.x.length === 2 && a.x.every(unit),
  neither: a => Array.isArray(a.x) && a.x.length === 2 && a.x.every(unit),
  like: a => unit(a.x),
  avoid: a => unit(a.x),
}));
function read(text) { // what is sound in a journal, and how many answers and materials of it are not
  const old = { answers: [], kept: [], gone: [], shelf: null, lost: 0 };
  if (!text) return old;
  try {
    const { answers = [], kept = [], gone = [], shelf } = JSON.parse(text), has = (e, good) => e && typeof e.id === 'string' && good || (++old.lost, false);
    old.answers = answers.filter(e => has(e, e && e.args && sound.has(e.call) && sound.get(e.call)(e.args))).map(({ id, call, args }) => ({ id, call, args }));
    old.kept = kept.filter(k => has(k, k && unit(k.x) && typeof k.name === 'string'));
    old.gone = gone.filter(id => typeof id === 'string');
    const number = v => typeof v === 'number' && isFinite(v), good = f => f && unit(f.x) && number(f.mean) && number(f.sigma);
    if (shelf && typeof shelf.of === 'string' && warnings[shelf.guessed] !== undefined && Array.isArray(shelf.found) && shelf.found.length === SHELF && shelf.found.every(good)) old.shelf = shelf;
  } catch (e) { ++old.lost; }
  return old;
}
function stash(key, text) {
  try { localStorage.setItem(key, text); return true; } catch (e) { return false; } // a private window, or no room
}
function last() {
  try { return localStorage.getItem(STORE); } catch (e) { return null; }
}
function store() {
  const old = read(last()), mine = new Set([...journal, ...studio.kept].map(e => e.id)), other = e => !mine.has(e.id);
  old.gone.forEach(id => gone.add(id));
  const left = e => !gone.has(e.id);
  stored = stash(STORE, JSON.stringify({
    answers: [...journal.map(({ id, call, args }) => ({ id, call, args })), ...old.answers.filter(other)].filter(left),
    kept: [...studio.kept.map(({ id, x, name }) => ({ id, x, name })), ...old.kept.filter(other)].filter(left), gone: [...gone].slice(-500),
    shelf: { of: studio.shelved, guessed: studio.guessed, found: studio.recommended.map(({ x, mean, sigma }) => ({ x, mean, sigma })) } }));
  changed = true;
}
// Answers and materials of an earlier visit, of another tab or of a file.
async function take({ answers, kept }) {
  const mine = new Set([...journal, ...studio.kept].map(e => e.id)), unknown = e => !mine.has(e.id) && !gone.has(e.id);
  answers = answers.filter(unknown);
  kept = kept.filter(unknown);
  for (const e of answers) { accept(e); journal.push(e); }
  undos = Math.min(undos + answers.length, UNDO);
  const replayed = answers.length ? told(mind.ask('replay', { answers: answers.map(({ id, call, args }) => ({ id, call, args })) }), answers.length) : [];
  const shown = answers.flatMap(e => e.shown);
  for (let i = 0; i < shown.length; i += 8) {
    const part = shown.slice(i, i + 8), pictures = await hand.ask('draw', { x: part.map(s => s.x) });
    part.forEach((s, k) => { s.picture = pictures[k]; piece(() => remember(s)); });
  }
  const pictures = kept.length ? await hand.ask('draw', { x: kept.map(k => k.x) }) : [];
  kept.forEach((k, i) => collect(k, pictures[i]));
  for (const id of await replayed) refused(answers.find(e => e.id === id));
  buttons();
  tell();
  return answers.length;
}
const plural = (n, word) => `${n} ${word}${n === 1 ? '' : 's'}`;
function notice(text) {
  $('notice').textContent = text;
  $('notice').hidden = !text;
}
let restoring = false;
async function restore() {
  const start = performance.now(), text = last(), old = read(text);
  old.gone.forEach(id => gone.add(id));
  if (old.shelf) studio.shelved = old.shelf.of; // nothing else is recommended while it is shown,
  restoring = Boolean(old.shelf); //               nor from a part of the answers
  const n = await take(old);
  restoring = false;
  if (old.shelf && n && old.shelf.of === answered()) await stock(old.shelf.found, old.shelf.guessed);
  else if (old.shelf && n) restock(true);
  studio.restored = performance.now() - start;
  if (n || old.kept.length) notice(`Welcome back: ${plural(n, 'answer')} and ${plural(old.kept.length, 'material')} of your last visit are here.`);
  if (old.lost) {
    stash(STORE + '-damaged', text);
    notice(`A part of your last visit could not be read: ${plural(n, 'answer')} and ${plural(old.kept.length, 'material')} could. The browser's storage has what was there, as ${STORE}-damaged.`);
  }
}
addEventListener('storage', e => {
  if (e.key !== STORE || !e.newValue || !studio.started) return;
  const old = read(e.newValue);
  old.gone.forEach(id => gone.add(id));
  take(old).catch(fail);
});
addEventListener('beforeunload', e => { if ((changed && !stored) || easel.unsaved) e.preventDefault(); });
$('anew').onclick = () => {
  if (!confirm('Forget all answers and the collection? Save them first if you want them back.')) return;
  try { localStorage.removeItem(STORE); } catch (e) { /* there is none */ }
  easel.unsaved = changed = false;
  location.reload();
};

// Answers as a table, as examples/data/scores.csv has them: build/recommend and build/workflow --scores read it. Answers that are no
// scores stand in lines that begin with #, which the tools skip.
function download(name, type, text) {
  const link = make('a', { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  studio.saved = typeof text === 'string' ? text : new TextDecoder().decode(text);
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
}
const header = Array.from({ length: M }, (_, k) => 'x' + k).join() + ',score\n';
$('save').onclick = () => {
  const others = journal.filter(e => !/score/.test(e.call));
  download('scores.csv', 'text/csv', header + studio.scored.map(s => `${s.x.join()},${s.score}\n`).join('') + others.map(e => `# ${e.call},${e.args.x.flat().join()}\n`).join(''));
  changed = false;
};
$('open').onclick = () => $('file').click();
$('file').onchange = async () => {
  const [file] = $('file').files;
  if (!file) return;
  try {
    const { answers, materials } = table(await file.text()), n = await take({ answers, kept: [] });
    if (materials.length) {
      const pictures = await hand.ask('draw', { x: materials });
      withdraw(studio.deck.splice(0));
      queue.unshift(...materials.map((x, k) => ({ x, picture: pictures[k] })));
      deal();
    }
    store();
    notice(`${file.name}: ${plural(n, 'new answer')}${materials.length ? `, ${plural(materials.length, 'material')} without a score: score them next` : ''}.`);
  } catch (e) {
    notice(`${file.name}: ${e.message}`);
  }
  $('file').value = '';
};
function table(text) {
  const answers = [], materials = [], scores = new Map(studio.scored.map(s => [s.x.join(), s]));
  let rows = 0;
  text.replace(/^\uFEFF/, '').split(/\r\n|\n|\r/).forEach((line, at) => {
    const wrong = what => { throw new Error(`line ${at + 1}: ${what}`); };
    const other = line.match(/^# (better|neither|like|avoid),(.*)/);
    if (other) {
      const v = other[2].split(',').map(Number), pair = /better|neither/.test(other[1]), args = { x: pair ? [v.slice(0, M), v.slice(M)] : v };
      if (!sound.get(other[1])(args)) wrong('not an answer that this page wrote');
      if (!journal.some(e => e.call === other[1] && e.args.x.join() === args.x.join())) answers.push({ id: fresh(), call: other[1], args });
    }
    if (line[0] === '#' || !line.trim()) return;
    const between = /[;\t]/.exec(line) || ',', cells = line.split(between[0]).map(c => c.trim()), v = cells.map(c => c === '' ? NaN : Number(between === ',' ? c : c.replace(',', '.')));
    if (rows++ === 0 && isNaN(v[0])) return; // the header
    if (cells.length !== M + 1) wrong(`${cells.length} columns, expected ${M} parameters and a score`);
    const x = v.slice(0, M), y = v[M], key = x.join(), old = scores.get(key);
    if (!unit(x)) wrong('a parameter is not a number from 0 to 1');
    if (cells[M] === '') return void (old || materials.push(x));
    if (!score(y)) wrong('the score is not a number from 0 to 10');
    if (!old) { const e = { id: fresh(), call: 'score', args: { x, score: y } }; answers.push(e); scores.set(key, { id: e.id, score: y }); }
    else if (old.score !== y) { answers.push({ id: fresh(), call: 'rescore', args: { of: old.id, score: y } }); scores.set(key, { id: old.id, score: y }); }
  });
  if (!rows && !answers.length) throw new Error('there are no materials in it');
  return { answers, materials };
}

// --------------------------------------------------------------------------------------------------------- recommendations
let restock;
function heard({ learned, settled, state, problem, doubt, picks, warning }) {
  if (problem) return fail(problem);
  if (learned !== studio.answers && settled) return; // more is under way
  if (settled) { ask(doubt); offer(picks); studio.unsupported = warning || ''; warn(); }
  if (state >= 2 && !restoring && studio.shelved !== answered()) restock(settled); // else they are what was here before a reload
  else if (settled) { studio.settled = true; tell(); }
}
// Comparisons in place of scores, where those found little that is liked.
let declined = false; // the offer of comparisons; once a session
function offer(picks) { $('picks').hidden = !picks || declined || mode === 'pair'; }
$('picks-yes').onclick = () => { byHand = true; answerBy('pair'); };
$('picks-no').onclick = () => { declined = true; offer(false); };
// Once for each score: was that a slip of the finger? The answer is to score it anew, or to say nothing.
const asked = new Set();
function ask(doubt) {
  const s = doubt && studio.scored.find(s => s.id === doubt.id && !s.gone);
  $('doubt').hidden = !s || asked.has(s.id + s.score);
  if ($('doubt').hidden) return;
  $('doubt-says').textContent = `You gave ${nameOf(s.x, s.picture)} a ${s.score}; about ${within(doubt.expected).toFixed(0)} was expected.`;
  $('doubt-change').onclick = () => { asked.add(s.id + s.score); $('doubt').hidden = true; rethink(s); };
  $('doubt-keep').onclick = () => { asked.add(s.id + s.score); $('doubt').hidden = true; };
}
const names = { diffuse: 'matt', metal: 'metal', glass: 'glass', jelly: 'translucent' };
// Sixteen recommendations, the one of the largest predicted score first. While learning goes on they change; those of a
// settled model are stored, and a reload shows them again.
const warnings = ['', 'Too little is known to tell all that you like: these are variants of what you scored above the lowest.',
  'No score is above the lowest yet: these are random materials.'];
restock = latest(async settled => {
  try {
    const of = answered(), { found, guessed } = await mind.ask('recommend', { count: SHELF });
    found.sort((a, b) => b.mean - a.mean);
    await stock(found, guessed);
    if (settled) { studio.shelved = of; store(); }
  } catch (e) {
    studio.recommended = [];
    studio.shelved = '';
    ghosts();
    warn('');
    $('advice').textContent = journal.length < 8 ? 'Keep going: nothing to go by yet.' : 'Nothing that you like so far. Score something a little higher, and I will find its friends.';
    if (journal.length >= 8) warn(`${e.message}.`.replace('..', '.'));
  }
  if (settled) studio.settled = true;
  tell();
});
// What the core has to say: of the scores (studio.unsupported), and of how these recommendations were found.
function warn(text = $('warning').text || '') {
  $('warning').text = text;
  $('warning').textContent = [studio.unsupported, text].filter(Boolean).join(' ');
  $('warning').hidden = !$('warning').textContent;
}
function ghosts() { $('shelf').replaceChildren(...Array.from({ length: SHELF }, () => make('i', { className: 'empty' }))); }
// What the shelf was made of: all answers, in their order.
const answered = () => journal.map(e => e.id).join();
async function stock(found, guessed) { // the shelf's buttons stay, their pictures change one after the other
  const pictures = await hand.ask('draw', { x: found.map(f => f.x) });
  found.forEach((f, k) => { f.picture = pictures[k]; });
  studio.recommended = found;
  studio.guessed = guessed;
  const shelf = $('shelf'), top = best(), version = ++studio.version;
  found.forEach((f, k) => piece(() => {
    if (version !== studio.version) return;
    let b = shelf.children[k];
    if (!b || !b.material) {
      const made = b = make('button', { className: 'pick' }, make('canvas', { className: 'ball', width: SIDE, height: SIDE }), make('b'), make('span', { className: 'face' }));
      b.onclick = () => { shelf.querySelectorAll('.chosen').forEach(e => e.classList.remove('chosen')); made.classList.add('chosen'); choose(made.material); reveal('walk'); };
      if (shelf.children[k]) shelf.children[k].replaceWith(b); else shelf.append(b);
      b.tabIndex = k ? -1 : 0;
    }
    b.material = f.x;
    b.dataset.x = f.x.map(v => v.toFixed(5)).join();
    b.classList.remove('chosen');
    b.title = b.ariaLabel = studio.scored.length ? `${nameOf(f.x, f.picture)}: about ${within(f.mean).toFixed(1)} ± ${f.sigma.toFixed(1)}` : nameOf(f.x, f.picture);
    b.querySelector('b').textContent = studio.scored.length ? within(f.mean).toFixed(1) : '';
    b.querySelector('b').hidden = !studio.scored.length;
    show(b.firstChild, f.picture);
    b.firstChild.getAnimations().forEach(a => { a.cancel(); a.play(); });
    b.lastChild.innerHTML = face(Math.min(Math.max(f.mean / top, 0), 1));
  }));
  $('advice').textContent = 'The best guess first. Click one to walk around it.';
  warn(warnings[guessed]);
  $('more').disabled = false;
}
// Scrolls to a section that was opened by a click elsewhere, unless most of it is in sight.
function reveal(id) {
  const section = $(id), still = matchMedia('(prefers-reduced-motion:reduce)').matches;
  section.classList.remove('closed');
  const r = section.getBoundingClientRect(), seen = Math.min(r.bottom, innerHeight) - Math.max(r.top, 0);
  if (seen < 0.7 * Math.min(r.height, innerHeight)) section.scrollIntoView({ behavior: still ? 'auto' : 'smooth', block: r.height > innerHeight ? 'start' : 'center' });
}
$('more').onclick = () => restock(studio.settled);

// What a delighted face stands for: without scores predictions have a scale of their own.
const best = () => studio.scored.length ? Math.max(10, ...studio.scored.map(s => s.score)) : Math.max(1e-3, ...studio.recommended.map(r => r.mean));
function tell() {
  const n = journal.length, r = studio.recommended, mean = r.length ? r.reduce((s, f) => s + f.mean, 0) / r.length / best() : 0.5;
  $('mood').innerHTML = face(n ? Math.min(Math.max(r.length ? mean : 0.35, 0), 1) : 0.7);
  const lobes = { diffuse: 0, metal: 0, glass: 0, jelly: 0 };
  r.forEach(f => { const s = shares(f.x); for (const k in s) lobes[k] += s[k] / r.length; });
  const top = Object.keys(lobes).sort((a, b) => lobes[b] - lobes[a]);
  const of = n < FIRST ? FIRST : GOOD, left = of - n;
  $('wanted').replaceChildren(...left <= 0 ? [] : [make('meter', { max: of, value: n, ariaLabel: 'answers so far' }),
    n < FIRST && !byHand ? `${plural(left, 'more choice')}, then scores.` : n < FIRST ? `${plural(left, 'more answer')} and I know where to look.` : `${plural(left, 'more answer')} make better ones; after ${GOOD} little changes.`]);
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
    $('walk').classList.remove('closed');
    $('lab').classList.remove('closed');
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
  $('where').textContent = studio.scored.length ? `I guess ${within(v.score).toFixed(1)} ± ${v.sigma.toFixed(1)}` : v.score > 0.8 * best() ? 'I think that you love it' : v.score > 0.5 * best() ? 'I think that you like it' : v.score > 0.2 * best() ? 'I am not sure about it' : 'I doubt that you like it';
  $('here-mix').replaceChildren(...Object.keys(s).map(k => {
    const e = make('i', { title: `${names[k]} ${Math.round(100 * s[k])}%` });
    e.style.cssText = `width:${100 * s[k]}%;background:rgb(${shown(v.x.slice(colors[k], colors[k] + 3))})`;
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
const easel = { x: null, dirty: false, unsaved: false, color: '#e8502a' };
const sliders = ['saturation', 'hue', 'light', 'tint'];
function begin(x, picture) {
  easel.x = x;
  easel.dirty = easel.unsaved = false;
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
  const value = s => Number($(s).value), c = easel.color.match(/\w\w/g).map(h => parseInt(h, 16) / 255), from = easel.x;
  const strokes = $('strokes').getContext('2d').getImageData(0, 0, SIDE, SIDE).data;
  const edit = { saturation: value('saturation'), hue: value('hue'), light: value('light'), tint: value('tint'), color: c };
  const { picture } = await hand.ask('paint', { x: from, edit, strokes }, [strokes.buffer]);
  if (from !== easel.x) return;
  show($('easel'), picture);
  for (const cost of [0, 60]) { // a first answer at once, a better one after it
    const m = await hand.ask('match', { x: from, cost });
    if (from !== easel.x) return;
    compare(m);
  }
});
const verdicts = ['', ': a part of the picture is not a material\u2019s', ': no material looks like this picture'];
const compare = timed(m => {
  studio.match = m;
  show($('matched'), m.picture);
  $('found').textContent = `${nameOf(m.x, m.picture)}, ${(100 * m.rmse).toFixed(1)}% away${verdicts[m.verdict]}`;
  $('adopt').disabled = $('keep-match').disabled = false;
});
function change() { if (easel.x) { easel.dirty = easel.unsaved = true; repaint(); } }
for (const s of sliders) $(s).oninput = change;
for (const c of ['#e8502a', '#f2b134', '#f6e7c1', '#5fae57', '#2a9d8f', '#2f7de1', '#7b4fd0', '#e05a9c', '#ffffff', '#22211f']) {
  const b = make('button', { title: c, ariaLabel: 'color ' + c, ariaPressed: String(c === easel.color) });
  b.style.setProperty('--c', c);
  b.onclick = () => { easel.color = c; for (const o of $('colors').children) o.ariaPressed = String(o === b); if (Number($('tint').value) > 0) change(); };
  $('colors').append(b);
  one($('colors'));
}
{
  const c = document.querySelector('.easel'), g = $('strokes').getContext('2d', { willReadFrequently: true }), tip = $('tip');
  let last = null;
  const at = e => { const r = c.getBoundingClientRect(); return [(e.clientX - r.left) / r.width * SIDE, (e.clientY - r.top) / r.height * SIDE]; };
  const dab = timed((from, to) => { // soft dabs along the way
    const size = Number($('size').value), n = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / (size / 5)));
    for (let k = 1; k <= n; ++k) {
      const x = from[0] + (to[0] - from[0]) * k / n, y = from[1] + (to[1] - from[1]) * k / n, soft = g.createRadialGradient(x, y, 0, x, y, size);
      soft.addColorStop(0, easel.color + '55');
      soft.addColorStop(0.5, easel.color + '33');
      soft.addColorStop(1, easel.color + '00');
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
$('brush').onclick = () => { begin(studio.view.x, studio.view.picture); reveal('lab'); };
$('like').onclick = e => { sparks(e.target, [heart]); says('like', { x: studio.view.x }); tell(); };
$('avoid').onclick = () => { says('avoid', { x: studio.view.x }); tell(); };
$('adopt').onclick = () => { if (studio.match) { easel.dirty = easel.unsaved = false; choose(studio.match.x); reveal('walk'); } };

// --------------------------------------------------------------------------------------------------------- the collection
function collect(item, picture) {
  const drop = make('button', { textContent: '×', ariaLabel: `remove ${item.name}` }), name = make('input', { value: item.name, ariaLabel: 'name', maxLength: 40, spellcheck: false });
  const e = make('div', { className: 'kept card' }, ball(picture), name, drop);
  name.onchange = () => { item.name = name.value = name.value.trim() || nameOf(item.x, picture); store(); };
  drop.onclick = () => {
    const next = (e.nextElementSibling || e.previousElementSibling || e).querySelector('button');
    studio.kept.splice(studio.kept.indexOf(item), 1);
    gone.add(item.id);
    e.remove();
    next.focus();
    store();
    count();
  };
  studio.kept.push(item);
  $('basket').append(e);
  count();
}
function keep(x, picture, at) {
  collect({ id: fresh(), x, name: nameOf(x, picture) }, picture);
  sparks(at, [star]);
  store();
}
function count() {
  $('empty').hidden = studio.kept.length > 0;
  $('csv').disabled = $('mtlx').disabled = studio.kept.length === 0;
  buttons();
}
$('keep').onclick = e => keep(studio.view.x, studio.view.picture, e.target);
$('keep-match').onclick = e => { easel.unsaved = false; keep(studio.match.x, studio.match.picture, e.target); };
// A material's own score, or the predicted one; none where nothing was answered.
async function worth({ x }) {
  const s = studio.scored.find(s => s.x.join() === x.join());
  return s ? s.score : journal.length ? within((await mind.ask('predict', { x }))[0]) : null;
}
async function save(kind) {
  const kept = studio.kept.slice(), scores = [], used = {};
  for (const k of kept) scores.push(await worth(k));
  if (kind === 'csv') // a name a line above each material, which the tools skip
    return download('materials.csv', 'text/csv', header + kept.map((k, i) => `# ${k.name}\n${k.x.map(v => v.toFixed(6)).join()},${scores[i] === null ? '' : Number(scores[i].toPrecision(4))}\n`).join(''));
  const names = kept.map(k => {
    const n = k.name.replace(/\W/g, '_').replace(/^(?=\d|$)/, 'm_');
    used[n] = (used[n] || 0) + 1;
    return used[n] > 1 ? `${n}__${used[n]}` : n;
  });
  download('materials.mtlx', 'application/xml', await mind.ask('save', { x: kept.map(k => k.x), names, scores: scores.map(s => s === null ? -1e9 : s) }));
}
$('csv').onclick = () => save('csv').catch(fail);
$('mtlx').onclick = () => save('mtlx').catch(fail);

// -------------------------------------------------------------------------------------------------------------- this or that
const prefer = timed(item => {
  const other = studio.deck.find(o => o !== item);
  if (!other || !studio.deck.includes(item)) return;
  sparks(item.card, [heart]);
  says('better', { x: [item.x, other.x] }, [item.picture, other.picture]);
  leave(other);
  leave(item);
  tell();
  setTimeout(nextMode, 240); // the two have left by then
});
const neither = timed(() => {
  if (studio.deck.length < 2) return;
  const pair = studio.deck.slice();
  says('neither', { x: pair.map(o => o.x) }, pair.map(o => o.picture));
  pair.forEach(leave);
  tell();
  setTimeout(nextMode, 240);
});
function answerBy(next) {
  if (next === mode) return;
  mode = next;
  offer(false);
  queue = [...studio.deck.map(({ x, picture }) => ({ x, picture })), ...queue];
  studio.deck.length = slots.length = 0;
  layDeck();
  deal();
  tell();
}
function layDeck() {
  for (const [id, m] of [['by-score', 'score'], ['by-pair', 'pair']]) $(id).ariaPressed = String(m === mode);
  $('keys').textContent = mode === 'pair' ? 'Keys: 1 and 2 choose, 0 is neither.' : 'Keys: 0 to 9 score the material in focus or under the pointer, + is ten; arrows and Enter as well.';
  $('deck').replaceChildren();
  $('deck').className = mode;
  if (mode !== 'pair') return;
  const b = make('button', { className: 'quiet', id: 'neither', textContent: 'Neither' });
  b.onclick = neither;
  $('deck').append(make('div', { className: 'pair-bar' }, b));
}
// The first answers are choices between two, which say more than scores do while little is known; then scores, unless somebody chose.
const FIRST = 10, GOOD = 60; // GOOD: from there recommendations hardly get better (tests/bench/RESULTS.md, active galleries)
function nextMode() { if (!byHand) answerBy(journal.length < FIRST ? 'pair' : 'score'); }
$('by-score').onclick = () => { byHand = true; answerBy('score'); };
$('by-pair').onclick = () => { byHand = true; answerBy('pair'); };

// ------------------------------------------------------------------------------------------------------------------- begin
(async () => {
  mode = read(last()).answers.length < FIRST ? 'pair' : 'score';
  layDeck();
  ghosts();
  tell();
  $('says').textContent = 'Waking up …';
  for (let k = 0; k < deckSize(); ++k) $('deck').prepend(make('div', { className: 'card waiting sleep' }, make('canvas', { className: 'ball', width: 8, height: 8 }), make('div', { className: 'name', textContent: ' ' })));
  await new Promise(r => setTimeout(r, 30)); // this much is seen before the networks are unpacked
  mind = worker(false);
  hand = worker(true);
  mind.heard = heard;
  await Promise.all([mind.ready, hand.ready]);
  await restore();
  studio.started = true;
  tell();
  fill();
})().catch(fail);
