// One of the studio's two workers: `mind` holds scores, recommendations and the plane, `hand` draws and matches pictures. Calls come as
// {id, call, args}, answers leave as {id, result} or {id, problem}. Between calls the mind learns, a slice at a time.
const M = 19, SIDE = 128, ROOM = 128;
let wasm, files, learning = false;
const floats = (at, n) => new Float64Array(wasm.memory.buffer, at, n);
const put = (at, values) => floats(at, values.length).set(values);
const take = (at, n) => Array.from(floats(at, n));
const sentence = () => {
  const b = new Uint8Array(wasm.memory.buffer, wasm.message(), 200);
  return new TextDecoder().decode(b.subarray(0, b.indexOf(0)));
};
const check = status => { if (status) throw new Error(sentence()); };
const pixels = (side = SIDE) => new Uint8ClampedArray(wasm.memory.buffer, wasm.rgba(), 4 * side * side).slice();
const rows = (count) => Array.from({ length: count }, (_, i) => take(wasm.x() + 8 * M * i, M));

async function unpack(base64) {
  const text = atob(base64), packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  return new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}

const calls = {
  async start({ binary, networks, matches }) {
    files = {};
    for (const name in networks) if (matches || name === 'renderer') files[name + '.safetensors'] = await unpack(networks[name]);
    wasm = await wasi(files).start(await unpack(binary));
    check(wasm.open(matches ? 1 : 0));
  },
  gallery({ count }) { check(wasm.gallery(count)); return rows(count); },
  // What the user says. Each counts as an answer.
  score({ id, x, score }) { put(wasm.x(), x); check(wasm.score(score)); row.set(id, wasm.scores() - 1); },
  rescore({ of, score }) {
    if (!row.has(of)) throw new Error('a material that is scored anew was never scored');
    check(wasm.rescore(row.get(of), score));
  },
  better({ x }) { put(wasm.x(), x.flat()); check(wasm.better()); },
  neither({ x }) { put(wasm.x(), x.flat()); check(wasm.neither(x.length)); },
  like({ x }) { put(wasm.x(), x); check(wasm.like(1)); },
  avoid({ x }) { put(wasm.x(), x); check(wasm.avoid()); },
  undo() { check(wasm.undo()); },
  // Many answers at once, and what is learned from all of them; the ids of those that were refused.
  replay({ answers }) {
    return answers.filter(({ id, call, args }) => {
      ++answered;
      try { calls[call]({ ...args, id }); } catch (e) { return true; }
    }).map(e => e.id);
  },
  recommend({ count }) {
    check(wasm.recommend(count));
    const mean = take(wasm.numbers(), 2 * count);
    return { found: rows(count).map((x, i) => ({ x, mean: mean[i], sigma: mean[count + i] })), guessed: wasm.guessed() };
  },
  predict({ x }) {
    put(wasm.x(), x);
    check(wasm.predict(1));
    return take(wasm.numbers(), 2);
  },
  choose({ x }) {
    put(wasm.x(), x);
    check(wasm.choose());
    const n = take(wasm.numbers(), 7);
    return { window: n.slice(0, 4), at: n.slice(4, 6), points: take(wasm.numbers() + 56, 2 * n[6]), ground: pixels(192) };
  },
  look({ points }) {
    const count = points.length / 2;
    put(wasm.numbers(), points);
    check(wasm.look(count));
    return { x: rows(count), variance: take(wasm.numbers(), count) };
  },
  move({ to }) {
    check(wasm.move(to[0], to[1]));
    const [score, sigma] = take(wasm.numbers(), 2);
    return { x: rows(1)[0], score, sigma, picture: pixels() };
  },
  draw({ x }) { // pictures of any number of materials
    return x.map(one => { put(wasm.x(), one); wasm.draw(0); return pixels(); });
  },
  paint({ x, edit, strokes }) {
    put(wasm.x(), x);
    new Uint8ClampedArray(wasm.memory.buffer, wasm.rgba(), 4 * SIDE * SIDE).set(strokes);
    check(wasm.paint(edit.saturation, edit.hue, edit.light, edit.tint, ...edit.color));
    return { picture: pixels() };
  },
  match({ x, cost }) {
    put(wasm.x(), x);
    check(wasm.match(cost));
    const [rmse, guess, verdict] = take(wasm.numbers(), 3);
    return { x: rows(1)[0], rmse, guess, verdict, picture: pixels() };
  },
  save({ x, names, scores }) {
    if (x.length > ROOM) throw new Error(`at most ${ROOM} materials can be saved at once`);
    put(wasm.x(), x.flat());
    put(wasm.numbers(), scores);
    const t = new TextEncoder().encode(names.join('\n').slice(0, 16000));
    new Uint8Array(wasm.memory.buffer, wasm.text(), t.length + 1).set([...t, 0]);
    check(wasm.save(x.length));
    return files['materials.mtlx'].slice();
  },
};

const row = new Map(), teaches = new Set(['score', 'rescore', 'better', 'neither', 'like', 'avoid', 'undo']); // row: of a score's id in the model
let answered = 0;
// A score that looks like a slip of the finger: its id, what it is and what was expected.
function doubt() {
  const at = wasm.outlier(), [id] = [...row].find(([, r]) => r === at) || [];
  return id ? { id, expected: take(wasm.numbers(), 2)[1] } : null;
}
function learn() {
  if (learning) return;
  learning = true;
  const slice = () => {
    if (!wasm.settled()) {
      const status = wasm.update();
      postMessage({ learned: answered, settled: status ? 1 : wasm.settled(), state: wasm.state(), problem: status ? sentence() : '' });
      if (!status) return void setTimeout(slice, 0);
    } else postMessage({ learned: answered, settled: 1, state: wasm.state(), problem: '', doubt: doubt(), picks: wasm.wants_picks(), warning: wasm.warning && wasm.warning() ? sentence() : '' });
    learning = false;
  };
  setTimeout(slice, 0);
}

onmessage = async ({ data: { id, call, args } }) => {
  if (teaches.has(call)) ++answered;
  if (teaches.has(call) || call === 'replay') learn();
  try {
    const result = await calls[call](args || {});
    const moved = [].concat(result || []).flatMap(r => r instanceof Uint8ClampedArray ? [r] : [r.picture, r.ground]).filter(Boolean);
    postMessage({ id, result }, moved.map(p => p.buffer));
  } catch (e) {
    postMessage({ id, problem: String(e.message || e) });
  }
};
