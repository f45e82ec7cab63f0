// The kernel designer: an object is lit in WebGL 2 and filtered by the shader files of ms_sss.h; kernels are made in a worker.
const $ = id => document.getElementById(id);
const make = (tag, props = {}, ...inside) => { const e = Object.assign(document.createElement(tag), props); e.append(...inside); return e; };
const fail = e => { console.error(String(e && e.message || e)); $('poster').hidden = true; $('says').hidden = false; $('says').textContent = 'Oh dear: ' + (e && e.message || e); };
function worker() {
  const w = new Worker(URL.createObjectURL(new Blob([$('wasi').textContent + $('worker').textContent], { type: 'text/javascript' }))), waiting = new Map();
  let id = 0;
  w.onmessage = ({ data }) => {
    const { yes, no } = waiting.get(data.id);
    waiting.delete(data.id);
    data.problem === undefined ? yes(data.result) : no(new Error(data.problem));
  };
  w.onerror = fail;
  w.ask = (call, args, moved = []) => new Promise((yes, no) => { waiting.set(++id, { yes, no }); w.postMessage({ id, call, args }, moved); });
  w.busy = () => waiting.size > 0;
  w.ready = w.ask('start', { binary: $('binary').textContent, files: [$('ms_sss').textContent, $('ms_sss_pyramid').textContent] });
  return w;
}
function latest(run) { // only the newest call runs; those that came while one did are dropped but the last
  let running = false, next = null;
  const go = async (...args) => {
    if (running) return void (next = args);
    running = true;
    try { await run(...args); } catch (e) { fail(e); }
    running = false;
    if (next) { const a = next; next = null; go(...a); }
  };
  go.busy = () => running;
  return go;
}

// ------------------------------------------------------------------------------------------------------------ what is drawn
const designer = window.designer = { object: 0, mode: 'split', split: 0.55, material: 8, frames: 0, kernel: null };
const size = Number(location.hash.slice(1)) || Math.min(960, Math.max(480, Math.round(Math.min(innerWidth * (innerWidth < 900 ? 1 : 0.56), 900) * Math.min(devicePixelRatio, 2))));
designer.size = size;
const canvas = $('view');
canvas.width = canvas.height = size;
const gl = canvas.getContext('webgl2', { antialias: false, alpha: false });

const corner = `#version 300 es
void main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }`;
const light = `#version 300 es
precision highp float; precision highp sampler3D;
THROUGH
uniform sampler2D surface, fine, tint; uniform sampler3D volume;
uniform vec3 low, high, sides, eye, reflectance, decay, power[3]; uniform vec4 lamp[3]; uniform mat3 axes;
uniform float cell, unit, mm, amount, plane; uniform int object;
layout(location = 0) out vec4 light; layout(location = 1) out vec4 shine; layout(location = 2) out vec4 behind;

float field(vec3 p) { // distance to the object, from its grid
    vec3 inside = clamp(p, low, high);
    float d = (texture(volume, ((inside - low) / cell + 0.5) / sides).r * 255.0 - 128.0) * unit;
    return d + distance(p, inside);
}
float wall(vec3 p) {
    float a = object == 0 ? p.y + 250.0 : p.y + 37.0, b = object == 0 ? p.z + 900.0 : p.z + 260.0, k = object == 0 ? 160.0 : 200.0, h = max(k - abs(a - b), 0.0) / k;
    return min(a, b) - 0.25 * k * h * h;
}
// The part of a round lamp that is seen: the nearest pass of the ray to its middle, as in scene.h.
float visible(vec3 p, vec3 n, vec4 l) {
    vec3 to = l.xyz - p, d = normalize(to);
    float len = length(to), t = 0.6 * cell, gap = 1.0, margin = min(l.w, 40.0), end = len;
    p += 0.25 * cell * n;
    vec3 inv = 1.0 / (d + vec3(1e-7)), a = (low - margin - p) * inv, b = (high + margin - p) * inv, near = min(a, b), far = max(a, b);
    t = max(t, max(near.x, max(near.y, near.z)));
    end = min(end, min(far.x, min(far.y, far.z)));
    for (int i = 0; i < 48 && t < end && gap > -1.0; ++i) {
        float f = field(p + t * d);
        gap = min(gap, f / (t * l.w / len));
        t += clamp(0.7 * f, 0.5 * cell, 60.0);
    }
    gap = max(gap, -1.0);
    return 0.25 * (1.0 + gap) * (1.0 + gap) * (2.0 - gap);
}
float lobe(float nl, float nv, float nh, float vh, float rough, float f0) { // GGX, Smith, Schlick
    float a2 = rough * rough * rough * rough, d = nh * nh * (a2 - 1.0) + 1.0, gl = nl + sqrt(a2 + (1.0 - a2) * nl * nl), gv = nv + sqrt(a2 + (1.0 - a2) * nv * nv);
    return (f0 + (1.0 - f0) * pow(1.0 - vh, 5.0)) * a2 / (3.14159265 * d * d) * nl / (gl * gv);
}
void main() {
    ivec2 at = ivec2(gl_FragCoord.xy);
    vec4 s = texelFetch(surface, at, 0), f = texelFetch(fine, at, 0), c = texelFetch(tint, at, 0);
    vec2 q = vec2(2.0, -2.0) * gl_FragCoord.xy / plane + vec2(-1.0, 1.0);
    vec3 ray = axes * vec3(q * 0.2126, -1.0), p = eye + ray * s.w, v = -normalize(ray), smoothed = axes * vec3(s.x, -s.y, s.z), n = normalize(f.xyz);
    bool under = c.a > 0.9, wet = c.a > 0.5;
    float nv = max(dot(n, v), 0.03), f0 = !wet ? 0.0 : !under ? 0.025 : object == 0 ? 0.028 : 0.04, rough = !under ? 0.1 : object == 0 ? 0.54 : 0.16;
    vec3 e = f.w * mix(vec3(0.026, 0.022, 0.020), vec3(0.045, 0.054, 0.068), 0.5 + 0.5 * n.y), g = vec3(0.0), b = vec3(0.0);
    for (int i = 0; i < 3; ++i) {
        vec3 to = lamp[i].xyz - p, l = normalize(to);
        float nl = dot(n, l), fall = dot(lamp[i].xyz, lamp[i].xyz) / dot(to, to);
        vec3 strength = power[i] * fall;
        if (nl > 0.0) {
            float seen = i == 2 ? 1.0 : visible(p, smoothed, lamp[i]);
            vec3 h = normalize(l + v);
            float gloss = f0 > 0.0 ? 0.9 * lobe(nl, nv, dot(n, h), dot(v, h), rough, f0) + 0.1 * lobe(nl, nv, dot(n, h), dot(v, h), 0.55 * rough, f0) : 0.0;
            e += seen * nl * strength / 3.14159265;
            g += seen * gloss * strength;
        }
        if (under && i < 2 && amount > 0.0 && dot(smoothed, l) < 0.0) { // what the lamp sends through
            float t = 0.75 * cell;
            for (int k = 0; k < 40; ++k) { float d = field(p + t * l); if (d > 0.0) break; t += max(-0.9 * d, 0.4 * cell); }
            vec3 x = p + t * l; vec2 o = vec2(0.6 * cell, 0.0);
            vec3 entry = normalize(vec3(field(x + o.xyy) - field(x - o.xyy), field(x + o.yxy) - field(x - o.yxy), field(x + o.yyx) - field(x - o.yyx)));
            b += visible(x, entry, lamp[i]) * ms_sss_transmission(reflectance, decay, t * mm, smoothed, entry, l, strength / 3.14159265);
        }
    }
    if (f0 > 0.0) { // a dim studio with a window
        vec3 r = reflect(-v, n);
        float soft = 0.06 + rough, window = r.z > 0.0 ? 1.0 : 0.0;
        window *= smoothstep(0.24 + soft, 0.24 - soft, abs(r.x + 0.55)) * smoothstep(0.26 + soft, 0.26 - soft, abs(r.y - 0.42));
        g += f.w * f.w * (f0 + (1.0 - rough - f0) * pow(1.0 - nv, 5.0)) * (mix(vec3(0.035, 0.035, 0.04), vec3(0.24, 0.27, 0.31), (0.5 + 0.5 * r.y) * (0.5 + 0.5 * r.y)) + window * vec3(0.76, 0.72, 0.66));
    }
    light = vec4(e, under ? s.w : 0.0);
    shine = vec4(g, 1.0);
    behind = vec4(amount * b, 1.0);
}`.replace(/smoothstep\((0\.2[46]) \+ soft, \1 - soft, /g, '(1.0 - smoothstep($1 - soft, $1 + soft, ').replace(/(abs\(r\.[xy] [+-] 0\.\d+\)\))/g, '$1)');
const compose = `#version 300 es
precision highp float;
uniform sampler2D before, after, shine, behind, tint; uniform vec3 reflectance; uniform float exposure, wipe, side; uniform int mode;
out vec4 color;
vec3 tone(vec3 v) {
    v = clamp(v * (2.51 * v + 0.03) / (v * (2.43 * v + 0.59) + 0.14), 0.0, 1.0); // Narkowicz's fit of ACES
    return mix(12.92 * v, 1.055 * pow(max(v, vec3(1e-5)), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, v));
}
vec3 picture(ivec2 at, bool filtered) {
    vec4 c = texelFetch(tint, at, 0);
    vec3 albedo = c.a > 0.9 ? 2.0 * c.rgb * reflectance : c.rgb, e = texelFetch(before, at, 0).rgb;
    if (filtered && c.a > 0.9) e = max(texelFetch(after, at, 0).rgb, texelFetch(behind, at, 0).rgb);
    return tone(exposure * (albedo * e + texelFetch(shine, at, 0).rgb));
}
vec3 smooth_picture(ivec2 at, bool filtered) { // outlines are averaged over a cross
    float kind = texelFetch(tint, at, 0).a, edge = 0.0;
    vec3 sum = vec3(0.0);
    for (int i = 0; i < 4; ++i) {
        ivec2 o = clamp(at + ivec2(i == 0 ? 1 : i == 1 ? -1 : 0, i == 2 ? 1 : i == 3 ? -1 : 0), ivec2(0), ivec2(side) - 1);
        edge += abs(texelFetch(tint, o, 0).a - kind) > 0.1 ? 1.0 : 0.0;
        sum += picture(o, filtered);
    }
    vec3 own = picture(at, filtered);
    return edge > 0.0 ? mix(own, 0.25 * sum, 0.6) : own;
}
void main() {
    ivec2 at = ivec2(gl_FragCoord.x, side - gl_FragCoord.y);
    if (mode == 2) color = vec4(4.0 * abs(picture(at, true) - picture(at, false)), 1.0);
    else color = vec4(smooth_picture(at, mode == 1 || gl_FragCoord.x > wipe * side), 1.0);
}`;

function program(text) {
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
  const places = {};
  return { p, at: name => name in places ? places[name] : places[name] = gl.getUniformLocation(p, name) };
}
function texture(format, type, kind, pixels = null, side = size) {
  const t = gl.createTexture();
  t.side = side;
  gl.bindTexture(gl.TEXTURE_2D, t);
  gl.texImage2D(gl.TEXTURE_2D, 0, format, side, side, 0, kind, type, pixels);
  for (const f of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, f, gl.NEAREST);
  for (const f of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T]) gl.texParameteri(gl.TEXTURE_2D, f, gl.CLAMP_TO_EDGE);
  return t;
}
function use(program, textures) {
  gl.useProgram(program.p);
  let unit = 0;
  for (const name in textures) {
    const place = program.at(name);
    if (!place) continue;
    gl.activeTexture(gl.TEXTURE0 + unit);
    gl.bindTexture(textures[name].volume ? gl.TEXTURE_3D : gl.TEXTURE_2D, textures[name].volume || textures[name]);
    gl.uniform1i(place, unit++);
  }
}
let target, targets, programs = {}, frame;
function onto(...to) {
  gl.bindFramebuffer(gl.FRAMEBUFFER, to.length ? frame : null);
  if (to.length) {
    for (let i = 0; i < 3; ++i) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, to[i] || null, 0);
    gl.drawBuffers(to.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
  }
  const side = to.length ? to[0].side : size;
  gl.viewport(0, 0, side, side);
}
// The targets of a way to filter, made when it is first drawn: half the size, or the levels of a pyramid.
const floats = side => texture(gl.RGBA32F, gl.FLOAT, gl.RGBA, null, side);
function half() { return targets.half = targets.half || { light: floats(size + 1 >> 1), middle: floats(size + 1 >> 1), after: floats(size + 1 >> 1) }; }
function levels(l) {
  targets.levels = targets.levels || [];
  while (targets.levels.length <= l) {
    let side = size;
    for (let k = targets.levels.length; k > 0; --k) side = side + 1 >> 1;
    targets.levels.push({ light: floats(side), surface: floats(side), sum: floats(side), weight: floats(side) });
  }
  return targets.levels[l];
}
// What a step of ms_sss.h (numbered as ms_sss_step) reads, and what it writes.
function wiring(way, step, level, normal) {
  const input = targets.light;
  if (way === 2) {
    const own = levels(level), next = step > 4 ? levels(level + 1) : own, all = { light: input, ms_sss_input: own.light, ms_sss_surface: own.surface,
      ms_sss_coarse: next.light, ms_sss_coarse_surface: next.surface, ms_sss_sum: next.sum, ms_sss_weight: next.weight };
    return step === 4 ? [{ light: input, normals: normal }, own.light, own.surface] : step === 5 ? [{ ms_sss_input: own.light, ms_sss_surface: own.surface }, next.light, next.surface]
      : step === 6 ? [all, own.sum, own.weight] : [all, targets.after];
  }
  if (way === 1) {
    const h = half();
    return { 2: [{ light: input }, h.light], 0: [{ ms_sss_input: h.light }, h.middle], 1: [{ ms_sss_input: h.middle, ms_sss_half: h.light }, h.after],
      3: [{ light: input, ms_sss_half: h.light, ms_sss_sum: h.after }, targets.after] }[step];
  }
  return step ? [{ ms_sss_input: targets.middle, light: input, normals: normal }, targets.after] : [{ light: input, normals: normal }, targets.middle];
}
const triangle = () => gl.drawArrays(gl.TRIANGLES, 0, 3);

const objects = [null, null];
const value = id => Number($(id).value);
const state = () => ({ mm: Math.pow(10, value('scale')), flat: 1 - value('elevation'), way: value('way') });
const lamps = () => {
  const bust = designer.object === 0, far = bust ? 697 : 289, a = value('azimuth') * Math.PI / 180, h = value('height') * Math.PI / 180, p = value('power');
  const key = [far * Math.sin(a) * Math.cos(h), far * Math.sin(h), far * Math.cos(a) * Math.cos(h)];
  return bust ? { lamp: [...key, 55, 400, 260, -560, 60, 560, 40, 420, 220], power: [3.3 * p, 2.95 * p, 2.5 * p, 1.2, 1.6, 2.2, 0.07, 0.09, 0.125] }
    : { lamp: [...key, 20, 170, 120, -190, 30, 150, 90, 260, 90], power: [3.3 * p, 3 * p, 2.6 * p, 1, 1.35, 1.9, 0.1, 0.125, 0.16] };
};
function draw() {
  const o = objects[designer.object], k = designer.kernel;
  if (!o || !k || !programs.light) return;
  const l = lamps(), set = (p, name, ...v) => gl['uniform' + v.length + 'f'](p.at(name), ...v);
  let p = programs.light;
  onto(targets.light, targets.shine, targets.behind);
  use(p, { surface: o.surface, fine: o.fine, tint: o.tint, volume: { volume: o.volume } });
  for (const name of ['low', 'high', 'sides', 'eye']) set(p, name, ...o.info[name]);
  gl.uniformMatrix3fv(p.at('axes'), false, o.info.axes);
  gl.uniform4fv(p.at('lamp'), l.lamp);
  gl.uniform3fv(p.at('power'), l.power);
  set(p, 'reflectance', ...k.reflectance);
  set(p, 'decay', ...k.decay);
  set(p, 'cell', o.info.cell);
  set(p, 'unit', o.info.step);
  set(p, 'mm', state().mm);
  set(p, 'amount', value('through'));
  set(p, 'plane', size);
  gl.uniform1i(p.at('object'), designer.object);
  triangle();
  for (const { step, level, text, constants } of k.steps) { // of ms_sss.glsl
    const pass = programs.steps.get(text), [read, ...to] = wiring(k.way, step, level, o.surface);
    onto(...to);
    use(pass, read);
    gl.uniform4fv(pass.at('ms_sss'), constants);
    triangle();
  }
  p = programs.compose;
  onto();
  use(p, { before: targets.light, after: targets.after, shine: targets.shine, behind: targets.behind, tint: o.tint });
  set(p, 'reflectance', ...k.reflectance);
  set(p, 'exposure', (designer.object ? 1.3 : 2.2) * 0.6 / (0.35 + 0.2126 * k.reflectance[0] + 0.7152 * k.reflectance[1] + 0.0722 * k.reflectance[2]));
  set(p, 'wipe', designer.split);
  set(p, 'side', size);
  gl.uniform1i(p.at('mode'), { split: 0, after: 1, difference: 2 }[designer.mode]);
  triangle();
  ++designer.frames;
}
let dirty = false;
function redraw() {
  if (dirty) return;
  dirty = true;
  requestAnimationFrame(() => { dirty = false; try { draw(); } catch (e) { fail(e); } });
}

// ---------------------------------------------------------------------------------------------------------------- the design
let maker, sculptors;
const own = () => {
  const c = $('color').value.match(/\w\w/g).map(h => Math.min(0.97, Math.max(0.02, Math.pow(parseInt(h, 16) / 255, 2.2))));
  if (designer.material === -2) return [Math.pow(10, value('melanin')), Math.pow(10, value('blood')), 0, 0, 0, 0];
  return [...c, ...[0, 1, 2].map(i => Math.pow(10, value('mfp' + i)))];
};
const perMm = () => size / (2 * 0.2126 * (designer.object ? 265 : 660)) / state().mm;
const design = latest(async () => {
  stale(true);
  const first = !designer.kernel;
  if (first) took(await maker.ask('design', { material: designer.material, own: own(), taps: 7, model: 1, pixels: perMm(), rough: true, size, ...state() })); // one to begin with
  const k = await maker.ask('design', { material: designer.material, own: own(), taps: value('taps'), model: Number($('model').value), pixels: perMm(), size, ...state() });
  took(k);
  facts(k);
});
const look = latest(async () => {
  if (!designer.kernel) return;
  stale(true);
  took({ ...designer.kernel, ...await maker.ask('look', { size, ...state() }) });
  facts(designer.kernel);
});
function took(k) {
  const old = designer.kernel;
  if (!old || old.through !== k.through) programs.light = program(light.replace('THROUGH', k.through));
  const steps = new Map();
  for (const { text } of k.steps) if (!steps.has(text)) steps.set(text, programs.steps && programs.steps.get(text) || program(text));
  programs.steps = steps;
  designer.kernel = k;
  redraw();
}
// The error of the filter that is chosen, with the passes that draw the picture: a white surface that faces the camera, half of it in the
// dark, upright or slanted, against the profile's own edge. Root of the mean square difference over 256 pixels across the edge, over the
// standard deviation of light and dark, as ms_sss_errors has it.
function edgeErrors(k) {
  const depth = designer.object ? 265 : 660, flat = texture(gl.RGBA32F, gl.FLOAT, gl.RGBA, new Float32Array(4 * size * size).map((_, i) => (i & 3) === 2 ? 1 : 0)), row = size >> 1;
  const errors = k.edges.map((edge, slanted) => {
    const across = (x, y) => slanted ? x + y - size + 1 : x - row + 0.5; // pixels, along the row; the slanted edge passes through pixels
    const light = new Float32Array(4 * size * size);
    for (let y = 0, i = 0; y < size; ++y)
      for (let x = 0; x < size; ++x, i += 4) {
        const d = across(x, y);
        light[i] = light[i + 1] = light[i + 2] = d > 0 ? 1 : d < 0 ? 0 : 0.5;
        light[i + 3] = depth;
      }
    const kept = targets.light, out = new Float32Array(4 * size);
    targets.light = texture(gl.RGBA32F, gl.FLOAT, gl.RGBA, light);
    for (const { step, level, text, constants } of k.steps) {
      const pass = programs.steps.get(text), [read, ...to] = wiring(k.way, step, level, flat);
      onto(...to);
      use(pass, read);
      gl.uniform4fv(pass.at('ms_sss'), constants);
      triangle();
    }
    onto(targets.after);
    gl.readPixels(0, row, size, 1, gl.RGBA, gl.FLOAT, out);
    gl.deleteTexture(targets.light);
    targets.light = kept;
    let sum = 0;
    for (let x = 0; x < size; ++x) {
      const d = across(x, row), i = slanted ? Math.abs(d) : Math.abs(d) - 0.5;
      if (i > 255) continue;
      for (let c = 0; c < 3; ++c) { const right = edge[3 * i + c]; sum += (out[4 * x + c] - (d < 0 ? 1 - right : right)) ** 2; }
    }
    return Math.sqrt(sum / 3 * (slanted ? Math.SQRT1_2 : 1) / 256) / 0.5;
  });
  gl.deleteTexture(flat);
  return errors;
}
function reads(k) { // as ms_sss.h says beside the steps
  const shaped = value('elevation') > 0, taps = 4 * k.taps - 2 + (shaped ? 2 : 0);
  return k.way === 2 ? (shaped ? 65 : 68) : k.way === 1 ? Math.round(10 + taps / 4 + (shaped ? 1 : 0)) : taps + 1;
}
function facts(k) {
  const taps = k.taps, percent = v => (100 * v).toFixed(v < 0.1 ? 1 : 0) + '%', [upright, slanted] = k.shown = edgeErrors(k), way = ['two passes', 'half resolution', 'the pyramid'][k.way];
  const stripes = k.errors.bands > 24, most = v => v <= 0.1;
  const list = [
    [percent(upright), `error at an upright shadow edge, ${way}`, !most(upright)], [percent(slanted), `error at a slanted one, ${way}`, !most(slanted)],
    ...k.way ? [] : [[percent(k.errors.texture), 'error on pictures of noise as in nature', !most(k.errors.texture)],
      [stripes ? 'faint stripes' : 'smooth', stripes ? 'beside a sharp shadow; more taps smooth them' : 'beside a sharp shadow', stripes]],
    [String(reads(k)), 'texels read a pixel'], k.way === 2 ? [String(k.steps.length), 'passes'] : [String(taps), 'taps a pass, two passes'],
    [k.pixels.toFixed(0) + ' px', `reach on the screen, ${k.radius < 10 ? k.radius.toFixed(1) : k.radius.toFixed(0)} mm`], [k.spent.toFixed(0) + ' ms', 'to make the kernel']];
  $('numbers').replaceChildren(...list.map(([v, what, bad]) => make('div', { className: bad ? 'bad' : '' }, make('b', { textContent: v }), what)));
  plot(k);
  swatch(k);
  stale(false);
}
// Figures and curves that are not of what is chosen are gray, and a word says that new ones are being computed.
function stale(yes) {
  $('computing').hidden = !yes;
  for (const e of document.querySelectorAll('#numbers, .plots')) e.classList.toggle('stale', yes);
}
const ink = ['#e4572e', '#3fa34d', '#3a7bd5'];
function plot(k) {
  const rows = Array.from({ length: 96 }, (_, i) => k.curves.slice(8 * i, 8 * i + 8)), w = 360, h = 200, left = 34;
  // the profile
  const values = rows.flatMap(r => r.slice(1, 4)).filter(v => v > 0), top = Math.ceil(Math.log10(Math.max(...values))), floor = Math.max(Math.floor(Math.log10(Math.min(...values))), top - 6);
  const y = v => 8 + (h - 16) * (top - Math.log10(Math.max(v, 1e-12))) / (top - floor), x = r => left + (w - left - 6) * r / k.radius;
  const ticks = n => { const s = Math.pow(10, Math.floor(Math.log10(n))), step = n / s < 2 ? s / 2 : n / s < 5 ? s : 2 * s, t = []; for (let v = 0; v <= n * 1.0001; v += step) t.push(v); return t; };
  let out = `<clipPath id="in"><rect x="${left}" y="4" width="${w - left}" height="${h - 8}"/></clipPath>`;
  for (let e = floor; e <= top; ++e) out += `<line class="grid" x1="${left}" x2="${w}" y1="${y(10 ** e)}" y2="${y(10 ** e)}"/><text x="${left - 4}" y="${y(10 ** e) + 3}" text-anchor="end">1e${e}</text>`;
  for (const t of ticks(k.radius)) out += `<text x="${x(t)}" y="${h + 10}" text-anchor="middle">${+t.toPrecision(3)}</text>`;
  for (let c = 0; c < 3; ++c) out += `<path clip-path="url(#in)" d="M${rows.filter(r => r[1 + c] > 0).map(r => x(r[0]).toFixed(1) + ' ' + y(r[1 + c]).toFixed(1)).join('L')}" fill="none" stroke="${ink[c]}" stroke-width="2.2"/>`;
  $('profile').innerHTML = out;
  // the kernel: a tap's weight over the width of its cell, beside the profile's line integral
  const taps = Array.from({ length: k.taps }, (_, i) => k.kernel.slice(4 * i, 4 * i + 4)).sort((a, b) => a[3] - b[3]), reach = Math.max(...taps.map(t => t[3])) * 1.06 || 1;
  const kx = v => left + (w - left - 6) * (v + reach) / (2 * reach), most = Math.max(...taps.flatMap(t => t.slice(0, 3))), ky = v => h - 8 - (h - 20) * v / most, lines = Math.max(...rows.flatMap(r => r.slice(5, 8)));
  out = `<line class="grid" x1="${left}" x2="${w}" y1="${ky(0)}" y2="${ky(0)}"/>`;
  for (const t of ticks(reach)) for (const s of t ? [-1, 1] : [1]) out += `<text x="${kx(s * t)}" y="${h + 10}" text-anchor="middle">${+(s * t).toPrecision(3)}</text>`;
  for (let c = 0; c < 3; ++c) {
    const half = rows.map(r => [r[4], r[5 + c]]).filter(r => r[0] < reach), line = [...half.map(r => [-r[0], r[1]]).reverse(), ...half];
    out += `<path d="M${line.map(r => kx(r[0]).toFixed(1) + ' ' + (h - 8 - (h - 20) * Math.pow(r[1] / lines, 0.5)).toFixed(1)).join('L')}" fill="none" stroke="${ink[c]}" stroke-opacity=".35" stroke-width="1.6"/>`;
    for (const t of taps) out += `<line x1="${kx(t[3]) + 2 * (c - 1)}" x2="${kx(t[3]) + 2 * (c - 1)}" y1="${ky(0)}" y2="${ky(Math.pow(t[c] / most, 0.5) * most).toFixed(1)}" stroke="${ink[c]}" stroke-width="2"/><circle cx="${kx(t[3]) + 2 * (c - 1)}" cy="${ky(Math.pow(Math.max(t[c], 0) / most, 0.5) * most).toFixed(1)}" r="2.6" fill="${ink[c]}"/>`;
  }
  $('kernel').innerHTML = out;
}
const display = c => `rgb(${c.map(v => Math.round(255 * Math.pow(Math.min(Math.max(v, 0), 1), 1 / 2.2)))})`;
function swatch(k) {
  const b = document.querySelector('#materials [aria-pressed=true] i');
  if (b) b.style.setProperty('--c', display(k.reflectance));
}

// ------------------------------------------------------------------------------------------------------------------- controls
function said() {
  const s = state(), text = { taps: value('taps'), scale: (s.mm < 0.995 ? '÷ ' + (1 / s.mm).toFixed(1) : s.mm > 1.005 ? '× ' + s.mm.toFixed(1) : 'life size'), elevation: Math.round(100 * value('elevation')) + '%',
    through: Math.round(100 * value('through')) + '%', azimuth: value('azimuth') + '°', height: value('height') + '°', power: value('power').toFixed(1) + '×' };
  for (let i = 0; i < 3; ++i) text['mfp' + i] = Math.pow(10, value('mfp' + i)).toPrecision(2) + ' mm';
  for (const id of ['melanin', 'blood']) text[id] = (100 * Math.pow(10, value(id))).toPrecision(2) + '%';
  for (const id in text) $(id).nextElementSibling.textContent = text[id];
}
for (const id of ['taps', 'model', 'scale', 'color', 'mfp0', 'mfp1', 'mfp2', 'melanin', 'blood']) $(id).addEventListener('input', () => { said(); design(); });
for (const id of ['elevation', 'way']) $(id).addEventListener('input', () => { said(); look(); });
for (const id of ['through', 'azimuth', 'height', 'power']) $(id).addEventListener('input', () => { said(); redraw(); });
for (const b of document.querySelectorAll('[data-object]')) b.onclick = () => pick(b, 'data-object', () => { designer.object = Number(b.dataset.object); $('says').hidden = !!objects[designer.object]; design(); });
for (const b of document.querySelectorAll('[data-mode]')) b.onclick = () => pick(b, 'data-mode', () => {
  designer.mode = b.dataset.mode;
  $('wipe').hidden = $('tag-left').hidden = designer.mode !== 'split';
  $('tag-right').textContent = designer.mode === 'difference' ? 'difference × 4' : 'after';
  redraw();
});
function pick(b, group, then) { for (const o of document.querySelectorAll(`[${group}]`)) o.ariaPressed = String(o === b); then(); }
{
  const f = document.querySelector('.frame'), wipe = $('wipe');
  wipe.onpointerdown = e => wipe.setPointerCapture(e.pointerId);
  wipe.onpointermove = e => { if (e.buttons) { const r = f.getBoundingClientRect(); designer.split = Math.min(0.98, Math.max(0.02, (e.clientX - r.left) / r.width)); wipe.style.left = 100 * designer.split + '%'; redraw(); } };
  let last = null;
  canvas.onpointerdown = e => { canvas.setPointerCapture(e.pointerId); last = [e.clientX, e.clientY]; still(); };
  canvas.onpointermove = e => {
    if (!last || !e.buttons) return;
    const turn = (id, by, least, most) => { $(id).value = Math.min(most, Math.max(least, value(id) + by)); };
    let a = value('azimuth') + 0.5 * (e.clientX - last[0]);
    $('azimuth').value = ((a + 540) % 360) - 180;
    turn('height', -0.4 * (e.clientY - last[1]), -60, 85);
    last = [e.clientX, e.clientY];
    said();
    redraw();
  };
  canvas.onpointerup = () => { last = null; };
}
let moving = 0;
const still = () => { moving = 0; $('play').ariaPressed = 'false'; $('play').textContent = 'Let it move'; };
$('play').onclick = () => {
  if (moving) return still();
  const mine = moving = performance.now(), from = value('azimuth');
  $('play').ariaPressed = 'true';
  $('play').textContent = 'Hold still';
  const turn = () => {
    if (moving !== mine) return;
    $('azimuth').value = ((from + 30 * (performance.now() - mine) / 1000 + 540) % 360) - 180;
    said();
    redraw();
    requestAnimationFrame(turn);
  };
  turn();
};
async function copy(button, text) {
  $('code').textContent = text;
  designer.copied = text;
  try { await navigator.clipboard.writeText(text); } catch (e) { // pages opened as files, in some browsers
    const r = document.createRange();
    r.selectNodeContents($('code'));
    getSelection().removeAllRanges();
    getSelection().addRange(r);
    document.execCommand('copy');
  }
  const old = button.textContent;
  button.textContent = 'copied';
  button.classList.add('done');
  setTimeout(() => { button.textContent = old; button.classList.remove('done'); }, 900);
}
for (const b of document.querySelectorAll('[data-code]')) b.onclick = () => maker.ask('code', { kind: Number(b.dataset.code) }).then(t => copy(b, t)).catch(fail);
for (const b of document.querySelectorAll('[data-shader]')) b.onclick = () => maker.ask('shader', { language: Number(b.dataset.shader), ...state() }).then(t => copy(b, t)).catch(fail);

// The bytes of the picture, for scripts.
designer.picture = () => {
  const out = new Uint8Array(4 * size * size);
  draw();
  gl.readPixels(0, 0, size, size, gl.RGBA, gl.UNSIGNED_BYTE, out);
  return Array.from(out.filter((_, i) => i % 4 < 3));
};

// The picture on the screen against ms_sss_filter: the largest difference over the largest value. At half resolution, which is the GPU's
// alone, against the filter at full resolution.
designer.check = async () => {
  draw();
  const read = t => { const out = new Float32Array(4 * size * size); onto(t); gl.readPixels(0, 0, size, size, gl.RGBA, gl.FLOAT, out); return out; };
  const input = read(targets.light), ours = read(targets.after), s = state();
  const { picture } = await maker.ask('filter', { light: input, normals: objects[designer.object].normals, size, ...s });
  let worst = 0, most = 0, changed = 0;
  for (let i = 0; i < picture.length; ++i) {
    if (i % 4 === 3 || !(input[i | 3] > 0)) continue;
    most = Math.max(most, input[i], picture[i]); // elevation lifts light above what came in
    worst = Math.max(worst, Math.abs(picture[i] - ours[i]));
    changed = Math.max(changed, Math.abs(picture[i] - input[i]));
  }
  return { worst: worst / most, changed: changed / most };
};
$('check').onclick = async () => {
  $('checked').textContent = '…';
  try {
    const { worst } = await designer.check();
    $('checked').textContent = `largest difference ${worst.toExponential(1)} of the brightest`;
  } catch (e) { fail(e); }
};

// ---------------------------------------------------------------------------------------------------------------------- begin
async function sculpt(object) { // coarse at once, then fine, band by band
  const w = sculptors[object];
  await w.ready;
  const info = await w.ask('volume', { object }), o = { info };
  o.volume = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_3D, o.volume);
  gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
  gl.texImage3D(gl.TEXTURE_3D, 0, gl.R8, ...info.sides, 0, gl.RED, gl.UNSIGNED_BYTE, info.bytes);
  for (const f of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_3D, f, gl.LINEAR);
  for (const f of [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T, gl.TEXTURE_WRAP_R]) gl.texParameteri(gl.TEXTURE_3D, f, gl.CLAMP_TO_EDGE);
  const l = await w.ask('coarse', { object, size });
  o.normals = l.surface;
  o.surface = texture(gl.RGBA32F, gl.FLOAT, gl.RGBA, l.surface);
  o.fine = texture(gl.RGBA32F, gl.FLOAT, gl.RGBA, l.fine);
  o.tint = texture(gl.RGBA8, gl.UNSIGNED_BYTE, gl.RGBA, l.tint);
  objects[object] = o;
  if (object === designer.object && $('poster').hidden) $('says').hidden = true;
  redraw();
  for (let y = 0, band = Math.ceil(size / 24); y < size; y += band) {
    const to = Math.min(size, y + band), f = await w.ask('layers', { object, size, from: y, to });
    const put = (t, type, data) => { gl.bindTexture(gl.TEXTURE_2D, t); gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, y, size, to - y, gl.RGBA, type, data); };
    gl.activeTexture(gl.TEXTURE0);
    put(o.surface, gl.FLOAT, f.surface);
    put(o.fine, gl.FLOAT, f.fine);
    put(o.tint, gl.UNSIGNED_BYTE, f.tint);
    o.normals.set(f.surface, 4 * size * y);
    if (object === designer.object) redraw();
  }
  o.whole = true;
  live();
}
// A picture of the page as it begins stands over the view until its head is whole, or until somebody touches anything.
function live() {
  if ($('poster').hidden) return;
  $('poster').hidden = true;
  $('says').hidden = !!objects[designer.object];
}
for (const touch of ['pointerdown', 'keydown', 'input']) addEventListener(touch, live, true);
designer.idle = () => !!designer.kernel && objects.every(o => o && o.whole) && !maker.busy() && !design.busy() && !look.busy() && !dirty;
(async () => {
  said();
  if (!gl || !gl.getExtension('EXT_color_buffer_float')) throw new Error('this browser has no WebGL 2 with float targets');
  frame = gl.createFramebuffer();
  targets = { light: texture(gl.RGBA32F, gl.FLOAT, gl.RGBA), middle: texture(gl.RGBA32F, gl.FLOAT, gl.RGBA), after: texture(gl.RGBA32F, gl.FLOAT, gl.RGBA),
    shine: texture(gl.RGBA16F, gl.HALF_FLOAT, gl.RGBA), behind: texture(gl.RGBA16F, gl.HALF_FLOAT, gl.RGBA) };
  programs.compose = program(compose);
  maker = worker();
  sculptors = [worker()];
  const rest = sculpt(0);
  const names = await maker.ready;
  [...names, 'skin, mixed', 'your own'].forEach((name, i) => {
    const b = make('button', { ariaPressed: String(i === designer.material) }, make('i'), name), tints = { apple: '#e9d28a', chicken1: '#dba98c', chicken2: '#d99f85', cream: '#fdf3dd', ketchup: '#8f1d0d', marble: '#eceae6', potato: '#e2cf8e', skimmilk: '#eef2f4', skin1: '#b97e63', skin2: '#d5a78b', wholemilk: '#fbf8f0' };
    b.setAttribute('data-material', name);
    b.firstChild.style.setProperty('--c', tints[name] || 'conic-gradient(#f66,#fc6,#6d6,#6cf,#c6f,#f66)');
    b.onclick = () => pick(b, 'data-material', () => { designer.material = i < names.length ? i : i - names.length - 2; $('own').hidden = designer.material !== -1; $('skin').hidden = designer.material !== -2; design(); });
    $('materials').append(b);
  });
  design();
  await rest;
  sculptors.push(worker());
  await sculpt(1);
})().catch(fail);
