// The designer's workers: one makes kernels, shaders and the CPU's pictures, one an object each makes the layers that are lit.
let wasm, files; // files: the texts of ms_sss.glsl and ms_sss_pyramid.glsl
const numbers = (at, n) => Array.from(new Float64Array(wasm.memory.buffer, wasm.numbers(), at + n).subarray(at));
const words = at => {
  const b = new Uint8Array(wasm.memory.buffer, at);
  return new TextDecoder().decode(b.slice(0, b.indexOf(0)));
};
const check = status => { if (status) throw new Error(words(wasm.message())); };
async function unpack(base64) {
  const text = atob(base64), packed = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) packed[i] = text.charCodeAt(i);
  return new Uint8Array(await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer());
}
// What goes before the shader files: the language, the #defines of a step, and how it reads the engine's textures. This page has light with
// depth in alpha, and normals; other languages are shown with a texture of each.
const heads = ['#version 330\n', '#version 300 es\nprecision highp float;\nprecision highp int;\nprecision highp sampler2D;\n', '#version 450\n#define MS_SSS_VULKAN\n', '#define MS_SSS_HLSL\n', ''];
const fetches = [
  `uniform sampler2D light, depth, normals;
vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(light, p, 0).rgb; }
float ms_sss_fetch_depth(ivec2 p) { return texelFetch(depth, p, 0).r; }
vec3 ms_sss_fetch_normal(ivec2 p) { return texelFetch(normals, p, 0).rgb; }
`,
  `uniform sampler2D light, normals;
vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(light, p, 0).rgb; }
float ms_sss_fetch_depth(ivec2 p) { return texelFetch(light, p, 0).a; }
vec3 ms_sss_fetch_normal(ivec2 p) { return texelFetch(normals, p, 0).rgb; }
`,
  `layout(set = 0, binding = 1) uniform sampler2D light;
layout(set = 0, binding = 2) uniform sampler2D depth;
layout(set = 0, binding = 7) uniform sampler2D normals;
vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(light, p, 0).rgb; }
float ms_sss_fetch_depth(ivec2 p) { return texelFetch(depth, p, 0).r; }
vec3 ms_sss_fetch_normal(ivec2 p) { return texelFetch(normals, p, 0).rgb; }
`,
  `Texture2D<float4> light : register(t1), depth : register(t2), normals : register(t7);
float3 ms_sss_fetch_color(int2 p) { return light.Load(int3(p, 0)).rgb; }
float ms_sss_fetch_depth(int2 p) { return depth.Load(int3(p, 0)).r; }
float3 ms_sss_fetch_normal(int2 p) { return normals.Load(int3(p, 0)).rgb; }
`,
  `@group(0) @binding(1) var light: texture_2d<f32>;
@group(0) @binding(2) var depth: texture_2d<f32>;
@group(0) @binding(7) var normals: texture_2d<f32>;
fn ms_sss_fetch_color(p: vec2<i32>) -> vec3<f32> { return textureLoad(light, p, 0).rgb; }
fn ms_sss_fetch_depth(p: vec2<i32>) -> f32 { return textureLoad(depth, p, 0).r; }
fn ms_sss_fetch_normal(p: vec2<i32>) -> vec3<f32> { return textureLoad(normals, p, 0).rgb; }
`];
function text({ language, way, step, flat }) {
  const all = '#define MS_SSS_STEP ' + step + '\n#define MS_SSS_TAPS ' + wasm.taps() + '\n#define MS_SSS_SLOPES ' + (flat < 1 ? 2 : 0) +
    '\n#define MS_SSS_HALF ' + (way === 1 ? 1 : 0) + '\n', file = files[0] + (step > 3 ? files[1] : '');
  if (language < 4) return heads[language] + all + fetches[language] + file;
  const bytes = new TextEncoder().encode(all + file + '\0'), at = wasm.room(bytes.length);
  new Uint8Array(wasm.memory.buffer).set(bytes, at);
  const status = wasm.wgsl(at);
  wasm.leave(at);
  check(status);
  return words(wasm.text()) + fetches[4];
}
const calls = {
  async start({ binary, files: given }) {
    files = given;
    wasm = await wasi({}).start(await unpack(binary));
    wasm.materials();
    return words(wasm.text()).trim().split('\n');
  },
  // A kernel with all that is shown of it, and what draws it in WebGL 2.
  design({ material, own, taps, model, pixels, rough, ...view }) {
    new Float64Array(wasm.memory.buffer, wasm.numbers(), 6).set(own);
    const t = performance.now();
    check(wasm.design(material, taps, model, pixels, rough ? 1 : 0));
    const spent = performance.now() - t, n = numbers(0, 16), curves = numbers(64, 8 * 96), count = wasm.taps();
    const result = { errors: { vertical: n[0], diagonal: n[1], dot: n[2], texture: n[3], bands: n[4] }, taps: count, radius: n[8], pixels: n[9], reflectance: n.slice(10, 13),
      decay: n.slice(13, 16), curves, kernel: numbers(64, 4 * count), spent };
    result.edges = [[0.5, 1], [0, Math.SQRT1_2]].map(([first, step]) => { // upright, from pixel to pixel; slanted, along a row
      wasm.edge(256, first * n[8] / n[9], step * n[8] / n[9]);
      return numbers(64, 3 * 256);
    });
    return Object.assign(result, calls.look(view));
  },
  // Steps as ms_sss_step numbers them, in the order in which they are drawn.
  plan({ way, size }) {
    if (way === 0) return [[0, 0], [1, 0]];
    if (way === 1) return [[2, 0], [0, 0], [1, 0], [3, 0]];
    const n = wasm.levels(size), plan = [[4, 0]];
    for (let l = 0; l + 1 < n; ++l) plan.push([5, l]);
    for (let l = n - 2; l > 0; --l) plan.push([6, l]);
    return [...plan, [7, 0]];
  },
  look({ size, way, mm, flat }) {
    if (way === 2) check(wasm.grow());
    const steps = calls.plan({ way, size }).map(([step, level]) => {
      const count = wasm.fill(size, size, way, step, level, mm, flat);
      if (!count) throw new Error(words(wasm.message()));
      return { step, level, text: text({ language: 1, way, step, flat }), constants: new Float32Array(wasm.memory.buffer, wasm.constants(), 4 * count).slice() };
    });
    return { way, steps, through: '#define MS_SSS_STEP 8\n' + files[0] };
  },
  code({ kind }) { check(wasm.code(kind)); return words(wasm.text()); },
  shader({ language, way, flat }) { // each text once: it serves all levels
    return [...new Set(calls.plan({ way, size: 8 }).map(s => s[0]))].map(step => text({ language, way, step, flat })).join('\n');
  },
  filter({ light, normals, size, way, mm, flat }) {
    if (way === 2) check(wasm.grow());
    const bytes = 16 * size * size, at = [0, 1, 2].map(() => wasm.room(bytes)), floats = k => new Float32Array(wasm.memory.buffer, at[k], bytes / 4);
    floats(0).set(light);
    floats(1).set(normals);
    const status = wasm.filter(at[0], at[1], at[2], size, size, way, mm, flat), out = floats(2).slice();
    at.forEach(a => wasm.leave(a));
    check(status);
    return { picture: out };
  },
  volume({ object }) {
    const at = wasm.volume(object), n = numbers(0, 23);
    if (!at) throw new Error('no memory for an object');
    const bytes = new Uint8Array(wasm.memory.buffer, at, n[6] * n[7] * n[8]).slice();
    wasm.leave(at);
    return { bytes, low: n.slice(0, 3), high: n.slice(3, 6), sides: n.slice(6, 9), cell: n[9], step: n[10], eye: n.slice(11, 14), axes: n.slice(14, 23) };
  },
  // All rows at a part of the resolution, each pixel as large as it takes.
  coarse({ object, size }) {
    const rough = Math.ceil(size / Math.max(1, Math.round(size / 160))), l = calls.layers({ object, size: rough, from: 0, to: rough });
    for (const name in l) {
      const from = new Uint32Array(l[name].buffer), each = from.length / (rough * rough), to = new Uint32Array(each * size * size);
      for (let y = 0, at = 0; y < size; ++y)
        for (let x = 0; x < size; ++x) {
          const pixel = each * (Math.floor(y * rough / size) * rough + Math.floor(x * rough / size));
          for (let c = 0; c < each; ++c) to[at++] = from[pixel + c];
        }
      l[name] = new l[name].constructor(to.buffer);
    }
    return l;
  },
  layers({ object, size, from, to }) {
    const n = (to - from) * size, at = [16 * n, 16 * n, 4 * n].map(b => wasm.room(b));
    wasm.layers(object, size, size, from, to, ...at);
    const result = { surface: new Float32Array(wasm.memory.buffer, at[0], 4 * n).slice(), fine: new Float32Array(wasm.memory.buffer, at[1], 4 * n).slice(),
      tint: new Uint8Array(wasm.memory.buffer, at[2], 4 * n).slice() };
    at.forEach(a => wasm.leave(a));
    return result;
  },
};
onmessage = async ({ data: { id, call, args } }) => {
  try {
    const result = await calls[call](args || {});
    postMessage({ id, result }, Object.values(result || {}).filter(v => ArrayBuffer.isView(v)).map(v => v.buffer));
  } catch (e) {
    postMessage({ id, problem: String(e.message || e) });
  }
};
