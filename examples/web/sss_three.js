// sources 2551818029
// Separable subsurface scattering for three.js, by ms_sss.h. `make web` writes this file: examples/web/sss_three.part.js and
// sss_core.part.js, examples/engine/shader/ms_sss.glsl (SHADER), and the header in WebAssembly (BINARY).
//
//   import { Subsurface } from './sss_three.js';
//   const sss = await Subsurface.create(renderer, [
//     { reflectance: [0.44, 0.22, 0.13], path: [1.3, 0.95, 0.67] },    a material's diffuse reflectance and mean free
//     { reflectance: [0.83, 0.79, 0.75], path: [0.46, 0.38, 0.33] }], path in mm, red, green, blue; at most 16
//     { mmPerUnit: 10, radius: 40 });                               the widest kernel on the screen, in pixels
//   sss.apply(head.material, 0);                    MeshStandardMaterial or MeshPhysicalMaterial, and which of them it is
//   sss.lamp = directionalLight;                    optional: light of this lamp passes through thin parts
//   sss.enabled = false;                            the materials are drawn as three.js alone draws them
//   every frame: sss.render(scene, camera); renderer.render(scene, camera);         or a composer's render
//
// sss.render draws the diffuse light of these materials without their color, and its depth; two passes scatter it, at half
// resolution where the radius is above 16 pixels: less work, and fewer streaks beside thin strips of light. The materials then read the scattered light in place of their own. Specular light, maps, shadows, tone mapping and
// post-processing are three's. Call it again after a resize, for every eye of a headset and every view that is rendered.
import * as THREE from 'three';

// What stands before SHADER in a pass: where it is in the light's texture what the pass reads.
const head = (step, taps, materials, half) => `precision highp float;
precision highp int;
precision highp sampler2D;
#define MS_SSS_STEP ${step}
#define MS_SSS_TAPS ${taps}
#define MS_SSS_PROFILES ${materials}
#define MS_SSS_HALF ${half}
uniform sampler2D light;
vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(light, p, 0).rgb; }
float ms_sss_fetch_depth(ivec2 p) { return texelFetch(light, p, 0).a; }
int ms_sss_fetch_profile(ivec2 p) { return floatBitsToInt(texelFetch(light, p, 0).a) & 15; }
`;

const patch = () => [ // of the fragment shader: where, and what stands there
  ['void main() {', `
uniform int sss_mode; // 0: scattered light, 1: write light and depth, 2: as without this
uniform int sss_index;
uniform highp sampler2D sss_light, sss_scattered, sss_lamp_map;
uniform mat4 sss_lamp_matrix; // from this camera's view to the lamp's clip space
uniform vec4 sss_lamp_range; // near, far, mm a unit, 1: there is a lamp
uniform vec3 sss_lamp_direction, sss_lamp_light, sss_reflectance, sss_decay;
uniform mat3 sss_lamp_normal; // from the lamp's view to this camera's
#define MS_SSS_STEP 8
${SHADER}
// From the lamp's map: what entered where the lamp sees this object before it sees the position; the mean of 4 x 4 texels by a tent
// that is two texels wide on each side, for a texel is as large as a pixel and its corners would be seen.
vec3 sss_behind(vec3 position, vec3 normal) {
  vec4 q = sss_lamp_matrix * vec4(position, 1.0);
  vec3 at = 0.5 * q.xyz + 0.5, sum = vec3(0.0);
  ivec2 size = textureSize(sss_lamp_map, 0);
  vec2 middle = at.xy * vec2(size) - 0.5, part = fract(middle);
  float own = mix(sss_lamp_range.x, sss_lamp_range.y, at.z);
  if (sss_lamp_range.w < 0.5 || min(at.x, at.y) < 0.0 || max(at.x, at.y) > 1.0 || dot(normal, sss_lamp_direction) >= 0.0) return sum;
  for (int i = 0; i < 16; ++i) {
    ivec2 o = ivec2(i & 3, i >> 2) - 1;
    vec2 tent = (2.0 - abs(vec2(o) - part)) * 0.25;
    vec4 entry = texelFetch(sss_lamp_map, clamp(ivec2(floor(middle)) + o, ivec2(0), size - 1), 0);
    if (entry.a > 0.0 && entry.a < own) sum += tent.x * tent.y * ms_sss_transmission(sss_reflectance, sss_decay, (own - entry.a) * sss_lamp_range.z,
      normal, sss_lamp_normal * entry.xyz, sss_lamp_direction, sss_lamp_light);
  }
  return sum;
}
void main() {`],
  ['#include <lights_physical_fragment>', `
  vec3 sss_albedo = diffuseColor.rgb * (1.0 - metalnessFactor);
  if (sss_mode == 1) { diffuseColor.rgb = vec3(1.0); metalnessFactor = 0.0; }
  #include <lights_physical_fragment>`],
  ['vec3 outgoingLight =', `
  if (sss_mode == 1) {
    gl_FragColor = vec4(totalDiffuse, intBitsToFloat(((floatBitsToInt(vViewPosition.z) + 8) & ~15) | sss_index));
    return;
  } else if (sss_mode == 0) { // where this fragment is what the pixel showed to sss.render, or at an antialiased edge one beside it
    ivec2 p = ivec2(gl_FragCoord.xy), best = p;
    float least = abs(texelFetch(sss_light, p, 0).a - vViewPosition.z), near = 0.02 * vViewPosition.z;
    for (int i = 0; i < 9 && least > near; ++i) {
      ivec2 beside = p + ivec2(i % 3 - 1, i / 3 - 1);
      float z = texelFetch(sss_light, beside, 0).a;
      if (abs(z - vViewPosition.z) < near && (floatBitsToInt(z) & 15) == sss_index) { best = beside; least = 0.0; }
    }
    if (least <= near) totalDiffuse = sss_albedo * max(texelFetch(sss_scattered, best, 0).rgb, sss_behind(-vViewPosition, normal));
  }
  vec3 outgoingLight =`]];

export class Subsurface {
  // materials: [{reflectance, path}]; options: mmPerUnit (1000: meters), radius (pixels that the taps are made for), taps (3 to 63; 0: as few
  // as show no bands at that radius, by the table of ms_sss_shader_constants), half (resolution, true or false)
  static async create(renderer, materials, { mmPerUnit = 1000, radius = 40, taps = 0, half = radius > 16 } = {}) {
    return new Subsurface(renderer, await Kernels.load('Subsurface'), materials, mmPerUnit, taps || Kernels.tapsOf(radius), radius, half);
  }

  constructor(renderer, kernels, materials, mmPerUnit, taps, radius, half) {
    if (!materials.length || !renderer.getContext().getExtension('EXT_color_buffer_float')) throw new Error('Subsurface: wants a material, and WebGL 2 with float targets');
    Object.assign(this, { renderer, kernels, mmPerUnit, taps, radius, half, given: materials, lamp: null, count: materials.length });
    this.materials = materials.map((material, i) => kernels.make(i, material, taps, radius));
    const target = () => new THREE.WebGLRenderTarget(1, 1, { type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter, depthBuffer: false });
    this.light = target();
    this.light.depthBuffer = true;
    this.between = target();
    this.scattered = target();
    [this.small, this.smallBetween, this.smallScattered] = half ? [target(), target(), target()] : [];
    this.lampMap = target();
    this.lampMap.depthBuffer = true;
    this.uniforms = {
      sss_mode: { value: 0 }, sss_light: { value: this.light.texture }, sss_scattered: { value: this.scattered.texture }, sss_lamp_map: { value: this.lampMap.texture },
      sss_lamp_matrix: { value: new THREE.Matrix4() }, sss_lamp_range: { value: new THREE.Vector4() }, sss_lamp_direction: { value: new THREE.Vector3() },
      sss_lamp_light: { value: new THREE.Vector3() }, sss_lamp_normal: { value: new THREE.Matrix3() } };
    this.constants = { value: new Float32Array(4) };
    const { light, between, scattered, small, smallBetween, smallScattered } = this, read = target => ({ value: target && target.texture });
    const steps = half // what each writes, and reads as ms_sss_input
      ? [[2, small], [0, smallBetween, small], [1, smallScattered, smallBetween], [3, scattered]]
      : [[0, between], [1, scattered, between]];
    this.passes = steps.map(([step, to, input]) => {
      const uniforms = { ms_sss: this.constants, light: read(light), ms_sss_input: read(input), ms_sss_half: read(small), ms_sss_sum: read(smallScattered) };
      const material = new THREE.RawShaderMaterial({
        glslVersion: THREE.GLSL3, uniforms, depthTest: false, depthWrite: false, blending: THREE.NoBlending,
        vertexShader: 'in vec3 position; void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
        fragmentShader: head(step, taps, this.count, Number(half)) + SHADER });
      return { material, to };
    });
    const triangle = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
    this.triangle = new THREE.Mesh(triangle, this.passes[0].material);
    this.triangle.frustumCulled = false;
    this.black = new THREE.MeshBasicMaterial({ color: 0, opacity: 0, blending: THREE.NoBlending, side: THREE.DoubleSide, fog: false }); // alpha 0: masked
    this.unseen = new THREE.MeshBasicMaterial({ colorWrite: false, depthWrite: false });
    this.lampCamera = new THREE.OrthographicCamera();
    this.lampMaterials = [true, false].map(enters => {
      const m = new THREE.MeshNormalMaterial({ side: THREE.DoubleSide, blending: THREE.NoBlending });
      m.onBeforeCompile = s => {
        s.uniforms.sss_lamp_range = this.uniforms.sss_lamp_range;
        s.fragmentShader = 'uniform vec4 sss_lamp_range;\n' + s.fragmentShader.replace(/}\s*$/,
          `gl_FragColor = vec4(${enters ? 'normalize(normal)' : 'vec3(0.0)'}, mix(sss_lamp_range.x, sss_lamp_range.y, gl_FragCoord.z));\n}`);
      };
      m.customProgramCacheKey = () => 'sss-lamp' + enters;
      return m;
    });
  }

  apply(material, index) {
    if (!this.materials[index] || !(material.isMeshStandardMaterial)) throw new Error(`Subsurface: wants a MeshStandardMaterial and an index below ${this.count}`);
    const { reflectance, decay } = this.materials[index];
    material.userData.subsurface = this;
    material.onBeforeCompile = s => {
      Object.assign(s.uniforms, this.uniforms, { sss_index: { value: index }, sss_reflectance: { value: reflectance }, sss_decay: { value: decay } });
      for (const [where, text] of patch()) {
        if (!s.fragmentShader.includes(where)) throw new Error('Subsurface: this version of three.js has no "' + where + '"');
        s.fragmentShader = s.fragmentShader.replace(where, () => text);
      }
    };
    material.customProgramCacheKey = () => 'sss';
    material.needsUpdate = true;
  }

  // Draws the scene with other materials: ours (yes: a material, or null: their own) and all others'.
  draw(scene, camera, target, yes, no) {
    const kept = [], { background, environment, overrideMaterial } = scene, mine = m => m.userData.subsurface === this;
    scene.traverseVisible(o => {
      if (!o.material) return;
      const of = m => mine(m) ? yes || m : m.transparent || !o.isMesh ? this.unseen : no;
      kept.push([o, o.material]);
      o.material = Array.isArray(o.material) ? o.material.map(of) : of(o.material);
    });
    scene.background = null;
    scene.overrideMaterial = null;
    this.renderer.setRenderTarget(target);
    try { this.renderer.clear(); this.renderer.render(scene, camera); }
    finally {
      for (const [o, m] of kept) o.material = m;
      Object.assign(scene, { background, environment, overrideMaterial });
    }
  }

  drawLamp(scene, camera) {
    const { lamp, lampCamera: eye, uniforms: u } = this;
    u.sss_lamp_range.value.w = 0;
    if (!lamp) return;
    const s = lamp.shadow.camera, size = lamp.shadow.mapSize;
    eye.copy(s, false);
    lamp.updateWorldMatrix(true, false);
    lamp.target.updateWorldMatrix(true, false);
    eye.position.setFromMatrixPosition(lamp.matrixWorld);
    eye.lookAt(new THREE.Vector3().setFromMatrixPosition(lamp.target.matrixWorld));
    eye.updateMatrixWorld();
    eye.updateProjectionMatrix();
    u.sss_lamp_range.value.set(eye.near, eye.far, this.mmPerUnit, 1);
    this.lampMap.setSize(size.x, size.y);
    const { autoUpdate } = this.renderer.shadowMap;
    this.renderer.shadowMap.autoUpdate = false;
    this.draw(scene, eye, this.lampMap, ...this.lampMaterials);
    this.renderer.shadowMap.autoUpdate = autoUpdate;
    const toLamp = eye.matrixWorldInverse.clone().multiply(camera.matrixWorld);
    u.sss_lamp_matrix.value.multiplyMatrices(eye.projectionMatrix, toLamp);
    u.sss_lamp_normal.value.setFromMatrix4(camera.matrixWorldInverse.clone().multiply(eye.matrixWorld));
    u.sss_lamp_direction.value.set(0, 0, 1).applyMatrix3(u.sss_lamp_normal.value);
    u.sss_lamp_light.value.fromArray(lamp.color.toArray()).multiplyScalar(lamp.intensity / Math.PI);
  }

  get enabled() { return this.uniforms.sss_mode.value !== 2; }
  set enabled(yes) { this.uniforms.sss_mode.value = yes ? 0 : 2; }

  render(scene, camera) {
    if (!this.enabled) return;
    const { renderer, uniforms } = this, { x, y } = renderer.getDrawingBufferSize(new THREE.Vector2());
    const target = renderer.getRenderTarget(), color = renderer.getClearColor(new THREE.Color()), alpha = renderer.getClearAlpha();
    for (const t of [this.light, this.between, this.scattered]) t.setSize(x, y);
    if (this.half) for (const t of [this.small, this.smallBetween, this.smallScattered]) t.setSize(Math.ceil(x / 2), Math.ceil(y / 2));
    if (camera.parent === null) camera.updateMatrixWorld();
    const { elements: m } = camera.projectionMatrix, fov = 360 / Math.PI * Math.atan(1 / m[5]);
    this.constants.value = this.kernels.constants(this.taps, this.count, x, y, fov, this.mmPerUnit, -m[8] * x / 2, -m[9] * y / 2);
    renderer.setClearColor(0, 0);
    try {
      this.drawLamp(scene, camera);
      uniforms.sss_mode.value = 1;
      uniforms.sss_light.value = this.between.texture; // a target must not be read
      this.draw(scene, camera, this.light, null, this.black);
      for (const { material, to } of this.passes) {
        this.triangle.material = material;
        renderer.setRenderTarget(to);
        renderer.render(this.triangle, camera);
      }
    } finally {
      uniforms.sss_mode.value = 0;
      uniforms.sss_light.value = this.light.texture;
      renderer.setRenderTarget(target);
      renderer.setClearColor(color, alpha);
    }
  }

  dispose() {
    for (const t of [this.light, this.between, this.scattered, this.small, this.smallBetween, this.smallScattered, this.lampMap]) t && t.dispose();
    for (const m of [...this.passes.map(pass => pass.material), ...this.lampMaterials, this.black, this.unseen]) m.dispose();
    this.triangle.geometry.dispose();
  }
}
// ms_sss.h in WebAssembly (BINARY: examples/web/three.c): kernels of materials, and the constants of both passes. `make web` puts this and the
// shader's text (SHADER) into sss_three.js and sss_babylon.js.
class Kernels {
  // name: what its messages begin with
  static async load(name) {
    const packed = Uint8Array.from(atob(BINARY), c => c.charCodeAt(0));
    const binary = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
    const nothing = new Proxy({}, { get: () => () => 52 }); // the header asks for no file
    const { instance } = await WebAssembly.instantiate(binary, { wasi_snapshot_preview1: nothing });
    instance.exports._initialize();
    return Object.assign(new Kernels(), { name, wasm: instance.exports });
  }

  // As few taps as show no bands at that radius in pixels, by the table of ms_sss_shader_constants.
  static tapsOf(radius) {
    return 2 * [1, 4, 8, 12, 16, 23, 29, 47, 65, 90, 115, 150].findIndex(most => Math.min(radius, 150) <= most) + 3;
  }

  numbers(count = 16) { return new Float64Array(this.wasm.memory.buffer, this.wasm.numbers(), count); }

  check(status) {
    if (!status) return;
    const bytes = new Uint8Array(this.wasm.memory.buffer, this.wasm.message());
    throw new Error(`${this.name}: ` + new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0))));
  }

  // Makes kernel i. reflectance, path: diffuse reflectance and mean free path in mm, of three channels. d: Burley's lengths in mm.
  make(i, { reflectance, path }, taps, radius) {
    this.numbers().set([...reflectance, ...path]);
    this.check(this.wasm.material(i, taps, radius));
    const n = Array.from(this.numbers());
    return { radiusMm: n[0], reflectance: n.slice(1, 4), decay: n.slice(4, 7), d: n.slice(7, 10) };
  }

  // The array ms_sss of both passes for the first `count` kernels. fov: vertical, in degrees; x, y: how far the axis is from the middle, in pixels.
  constants(taps, count, width, height, fov, mmPerUnit, x = 0, y = 0) {
    const n = this.wasm.fill(taps, count, width, height, fov, mmPerUnit, x, y);
    if (!n) this.check(1);
    return new Float32Array(this.wasm.memory.buffer, this.wasm.constants(), 4 * n).slice();
  }
}

const SHADER = `
// Subsurface scattering in screen space: the passes X and Y, half resolution, and light through thin parts.
//
// One text for GLSL 330, GLSL ES 300 (WebGL 2), GLSL for Vulkan and HLSL; examples/tools/sss_wgsl.c makes WGSL of it.
// A fragment shader is a line of #version, #defines, the engine's functions that read its textures, and this file:
//
//     #version 330
//     #define MS_SSS_STEP 0
//     uniform sampler2D light, depth;
//     vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(light, p, 0).rgb; }
//     float ms_sss_fetch_depth(ivec2 p) { return texelFetch(depth, p, 0).r; }
//
// A triangle over the target runs it. ms_sss_shader_constants of ms_sss.h fills the array ms_sss: an array of
// uniforms, or the constant buffer at binding 0.
//
//     #define             default
//     MS_SSS_STEP                  0 X, 1 Y, 2 DOWN, 3 UP; 8 ms_sss_transmission alone, for the engine's light loop;
//                                  4 to 7: those of ms_sss_pyramid.glsl, which follows this file; 9: ms_sss_disc.glsl
//     MS_SSS_TAPS         7        ms_sss_shader.tap_count
//     MS_SSS_PROFILES     0        kernels that ms_sss_fetch_profile selects from, up to 16; 0: one, no profiles
//     MS_SSS_TERMS        1        of UP: the most terms of any of the kernels
//     MS_SSS_PERSPECTIVE  1        0: orthographic, or a light map
//     MS_SSS_FLAT         0        1: without slopes and elevation, where options.flat is 1
//     MS_SSS_NORMAL       0        1: slopes from normals; 0: from depth
//     MS_SSS_STRENGTH     0        1: with strength
//     MS_SSS_ROTATED      0        1: rotation or jitter of ms_sss_shader
//     MS_SSS_HALF         0        1: X and Y lie between DOWN and UP
//     MS_SSS_HLSL, MS_SSS_VULKAN   defined: the language, where it is not the GLSL of OpenGL (MS_SSS_WGSL: by sss_wgsl.c)
//
// The engine defines those of these functions that a step reads; p is the pixel plus the viewport's corner:
//
//     float3 ms_sss_fetch_color(int2 p)     light before the albedo; not below 1e30: masked     X, Y, DOWN, UP
//     float ms_sss_fetch_depth(int2 p)      along the view axis; not > 0: masked                X, DOWN, UP
//     int ms_sss_fetch_profile(int2 p)      index of the kernel; without one: masked            X, DOWN, UP
//     float ms_sss_fetch_strength(int2 p)   0 to 1; 0: masked                                   X, Y, DOWN, UP
//     float3 ms_sss_fetch_normal(int2 p)    in view space: x right, y down, z to the camera     X, Y
//
// BASE and the disc read what X reads, RESOLVE color and strength. At half resolution X and Y read DOWN's target in their
// place. Without depth the second returns 1.0, with MS_SSS_FLAT 1. Depth of 16-bit floats also wants MS_SSS_FLAT 1: its
// steps are seen as elevation, even where slopes are from normals.
// Targets are textures of 32-bit floats (OpenGL: GL_NEAREST), at these bindings:
//
//     X     writes light, and depth (0: masked) in alpha; the profile in the last 4 bits of blue
//     Y     the result; reads ms_sss_input (4): X's target. The Y of further terms are added to it by blending
//     DOWN  writes as X. Then X reads ms_sss_input: DOWN's target, and Y also ms_sss_half (12): DOWN's target
//     UP    the result; reads ms_sss_half (12): DOWN's target, and ms_sss_sum (6): Y's target

#ifndef MS_SSS_TAPS
#define MS_SSS_TAPS 7
#endif
#ifndef MS_SSS_PROFILES
#define MS_SSS_PROFILES 0
#endif
#ifndef MS_SSS_TERMS
#define MS_SSS_TERMS 1
#endif
#ifndef MS_SSS_PERSPECTIVE
#define MS_SSS_PERSPECTIVE 1
#endif
#ifndef MS_SSS_FLAT
#define MS_SSS_FLAT 0
#endif
#ifndef MS_SSS_NORMAL
#define MS_SSS_NORMAL 0
#endif
#ifndef MS_SSS_STRENGTH
#define MS_SSS_STRENGTH 0
#endif
#ifndef MS_SSS_ROTATED
#define MS_SSS_ROTATED 0
#endif
#ifndef MS_SSS_HALF
#define MS_SSS_HALF 0
#endif

// ---- languages -------------------------------------------------------------------------------------------------------

#if defined(MS_SSS_HLSL)
#define bits_of asuint
#define float_of asfloat
#define TEXTURE(name, read, slot, at) Texture2D<float4> name : register(at); float4 read(int2 p) { return name.Load(int3(p, 0)); }
#elif !defined(MS_SSS_WGSL) // whose macros the tool has
#define int2 ivec2
#define float2 vec2
#define float3 vec3
#define float4 vec4
#define bits_of floatBitsToUint
#define float_of uintBitsToFloat
#ifdef MS_SSS_VULKAN
#define TEXTURE(name, read, slot, at) layout(set = 0, binding = slot) uniform sampler2D name; vec4 read(ivec2 p) { return texelFetch(name, p, 0); }
#else
#define TEXTURE(name, read, slot, at) uniform sampler2D name; vec4 read(ivec2 p) { return texelFetch(name, p, 0); }
#endif
#endif
#ifndef MS_SSS_WGSL
#define CONSTANT ms_sss
#define pick(if_not, if_so, condition) ((condition) ? (if_so) : (if_not))
#endif
#define zero2 float2(0.0, 0.0)
#define zero3 float3(0.0, 0.0, 0.0)
#define zero4 float4(0.0, 0.0, 0.0, 0.0)
#define one3 float3(1.0, 1.0, 1.0)

#if MS_SSS_STEP != 8
// ---- what the step is ------------------------------------------------------------------------------------------------

#define PASS (MS_SSS_STEP < 2)
#define SECOND (MS_SSS_STEP == 1)
#define DOWN (MS_SSS_STEP == 2)
#define UP (MS_SSS_STEP == 3)
#define PYRAMID (MS_SSS_STEP > 3 && MS_SSS_STEP < 8)
#define BASE (MS_SSS_STEP == 4)
#define GATHER (MS_SSS_STEP == 6)
#define RESOLVE (MS_SSS_STEP == 7)
#define DISC (MS_SSS_STEP == 9)
#define HALVED (PASS && MS_SSS_HALF > 0)
// RAW: it reads the engine's textures and masks their pixels, where others read the target of a step.
#define RAW (BASE || DOWN || UP || DISC || (MS_SSS_STEP == 0 && !HALVED))
#define SLOPES (MS_SSS_FLAT == 0 && (PASS || BASE || DISC))
#define NORMALS (MS_SSS_NORMAL > 0 && SLOPES && !HALVED)
#define PACKED (MS_SSS_PROFILES > 0 && !PYRAMID)

// Float4 of the constants: before the profiles (HEAD), of a profile (STRIDE), and in all.
#define STRIDE (6 + MS_SSS_TAPS / 2)
#if MS_SSS_PROFILES > 0
#define KERNELS MS_SSS_PROFILES
#else
#define KERNELS 1
#endif
#define SIZES 49 // of a pyramid's table
#if RESOLVE
#define HEAD 7
#define COUNT (HEAD + 3 * SIZES)
#elif GATHER
#define HEAD 7
#define COUNT (HEAD + SIZES)
#elif PYRAMID
#define HEAD 7
#define COUNT HEAD
#elif UP
#define HEAD 4
#define COUNT (HEAD + MS_SSS_TERMS * KERNELS * STRIDE)
#else
#define HEAD 4
#define COUNT (HEAD + KERNELS * STRIDE)
#endif

// ---- constants and textures ------------------------------------------------------------------------------------------

#if defined(MS_SSS_HLSL)
cbuffer ms_sss_block : register(b0) { float4 ms_sss[COUNT]; };
#elif defined(MS_SSS_VULKAN)
layout(set = 0, binding = 0) uniform ms_sss_block { vec4 ms_sss[COUNT]; };
#elif !defined(MS_SSS_WGSL)
#ifdef GL_ES
precision highp float;
precision highp int;
precision highp sampler2D;
#endif
uniform vec4 ms_sss[COUNT];
#endif

#define PICTURE_SIZE CONSTANT[0].xy // in pixels, of the picture at full resolution
#define CENTER CONSTANT[HEAD - 1].xy // of the projection, in pixels
#define ORIGIN CONSTANT[HEAD - 1].zw // the viewport's corner
// of X, Y, DOWN and UP
#define PIXELS_PER_MM CONSTANT[0].z // perspective: at depth 1
#define GAIN CONSTANT[0].w // 1 - fade
#define ASPECT CONSTANT[1].xy // pixels a mm along x and y, relative to PIXELS_PER_MM
#define ROTATION CONSTANT[1].z // radians
#define JITTER CONSTANT[1].w
#define FIRST_TERM CONSTANT[2].x // 1: the term that adds the light itself
#define FOCAL CONSTANT[2].yz // pixels a unit of depth; perspective: at depth 1
#define SLOPE_SCALE CONSTANT[2].w // 1 - flat
// of a profile's kernel, which begins at HEAD + STRIDE * profile
#define TOTAL(at) CONSTANT[at] // sums of the weights; radius
#define RADIUS_MM(at) CONSTANT[at].w
#define SCALE(at) CONSTANT[at + 1].rgb // of the term
#define DEPTH_SCALE(at) CONSTANT[at + 1].w // to units of depth in which weights vanish at a difference of 1
#define DELTA(at) CONSTANT[at + 2].rgb // the part of the light that the filter leaves where it is
#define SPLIT(at) CONSTANT[at + 2].w // square of the difference of depth that DOWN and UP do not cross
#define ELEVATION(at) CONSTANT[at + 3].rgb // K / 4
#define MIXED(at) CONSTANT[at + 3].w // bits: channels with weights of both signs
#define ROOT(at) CONSTANT[at + 4].rgb // of the reflectance
#define REACH(at) CONSTANT[at + 4].w // square of the kernel's radius in units of depth
#define TAP(at, i) CONSTANT[at + 5 + i] // weight; offset in mm. 0: the center; then one of each pair

#if !RAW
TEXTURE(ms_sss_input, fetch_input, 4, t4)
#endif
#if UP || GATHER || RESOLVE
TEXTURE(ms_sss_sum, fetch_sum, 6, t6)
#endif
#if UP || (SECOND && HALVED)
TEXTURE(ms_sss_half, fetch_half, 12, t12)
#endif

// ---- a pixel: its light, depth, profile, and the slopes of its surface ------------------------------------------------

// Pixels of the picture along the side of one of this step's.
float side() { return pick(pick(1.0, 2.0, HALVED), 0.5 * CONSTANT[2].z, PYRAMID); }

// The corner of the viewport; targets of half the size have none.
int2 origin() { return int2(int(ORIGIN.x), int(ORIGIN.y)) * pick(1, 0, HALVED); }

bool inside(int2 p) {
    int step = int(side());
    return p.x >= 0 && p.y >= 0 && step * p.x < int(PICTURE_SIZE.x) && step * p.y < int(PICTURE_SIZE.y);
}

// In perspective a pixel shows a width in proportion to its depth.
float relative(float depth) { return pick(1.0, depth, MS_SSS_PERSPECTIVE > 0); }

// (x, y) / z of a pixel's ray.
float2 ray_of(int2 p) {
    float2 middle = float2(float(p.x) + 0.5, float(p.y) + 0.5) * side();
#if PYRAMID
    return (middle - CENTER) * CONSTANT[1].w; // its tangent
#else
    return (middle - CENTER) * float(MS_SSS_PERSPECTIVE) / FOCAL.x;
#endif
}

// The area of a surface over that of a surface that faces the ray, at the same depth: |(slope, 1 + slope . ray)|.
float area_of(float2 slope, float2 ray) {
    float towards = dot(slope, ray) + 1.0;
    return sqrt(dot(slope, slope) + towards * towards);
}

#if PASS || DOWN || UP || BASE || DISC
// Below 1e30, by its bits: compilers may assume that no number is NaN.
bool finite(float x) { return (bits_of(x) & 0x7fffffffu) < 0x7149f2cau; }

#if PACKED
// The last 4 bits of blue hold the profile. Those of 0 would be flushed, so 0 becomes 1e-30.
float pack(float blue, int profile) {
    return float_of(((bits_of(pick(blue, 1e-30, abs(blue) < 1e-30)) + 8u) & 0xfffffff0u) | uint(profile));
}
int profile_of(float4 c) { return int(bits_of(c.b) & 15u); }
#else
float pack(float blue, int profile) { return blue; }
int profile_of(float4 c) { return 0; }
#endif

// Light and depth of a pixel; alpha 0: masked.
float4 source(int2 p) {
#if RAW
    int2 at = p + origin();
    float3 c = ms_sss_fetch_color(at);
    float depth = ms_sss_fetch_depth(at);
    int profile = 0;
    bool valid = finite(c.r) && finite(c.g) && finite(c.b) && depth > 0.0 && finite(depth);
#if MS_SSS_STRENGTH
    float strength = ms_sss_fetch_strength(at);
    valid = valid && strength > 0.0 && (bits_of(strength) & 0x7fffffffu) <= 0x7f800000u;
#endif
#if MS_SSS_PROFILES > 0
    profile = ms_sss_fetch_profile(at);
#if PYRAMID
    valid = valid && profile == int(CONSTANT[0].w);
#else
    valid = valid && profile >= 0 && profile < MS_SSS_PROFILES;
#endif
#endif
    if (!valid) { return zero4; }
    return float4(c.rg, pack(c.b, profile), depth);
#else
    float4 c = fetch_input(p + origin());
    return pick(zero4, c, c.a > 0.0);
#endif
}

float4 texel(int2 p) {
    if (!inside(p)) { return zero4; }
    return source(p);
}

// Neither is masked, and both have one profile.
bool same(float4 a, float4 b) { return a.a > 0.0 && profile_of(a) == profile_of(b); }
#endif

#if SLOPES && !NORMALS
// The slope along a step of one pixel, from differences of depth to the pixels before and after. A difference above
// most is an edge. Where the slopes on both sides agree, their mean. Else the smaller one: near a silhouette depth
// falls as the root of the distance to it, a difference of one pixel underestimates the slope, and the ratio of the last
// two differences tells by how much, if it is more than rounding.
float slope_along(int2 p, int2 step, float4 own, float focal, float most) {
    float4 before = texel(p - step);
    float4 after = texel(p + step);
    float a = own.a - before.a;
    float b = after.a - own.a;
#if !PYRAMID
    bool on_a = same(before, own) && abs(a) < most;
    bool on_b = same(after, own) && abs(b) < most;
#endif
    a = focal * a / relative(before.a);
    b = focal * b / relative(after.a);
#if PYRAMID // there most is of slopes
    bool on_a = same(before, own) && abs(a) < most;
    bool on_b = same(after, own) && abs(b) < most;
#endif
    a = pick(pick(0.0, b, on_b), a, on_a);
    b = pick(a, b, on_b);
    float slope = 0.5 * (a + b);
    if ((on_a || on_b) && !(on_a && on_b && abs(a - b) < 0.5 * (a * b + 1.0))) {
        bool back = on_a && (!on_b || abs(a) < abs(b));
        if (abs(a) < abs(b)) { slope = a; }
        if (abs(b) < abs(a)) { slope = b; }
        float next = pick(after.a, before.a, back);
        float4 beyond = texel(p + step * pick(2, -2, back));
        float outer_step = (own.a - next) * relative(beyond.a);
        float inner_step = (next - beyond.a) * relative(own.a);
#if PYRAMID
        float rounding = 2.0 * CONSTANT[5].z * own.a * relative(own.a);
#else
        float rounding = 4.7683716e-7 * own.a * relative(own.a);
#endif
        float more = min(abs(outer_step) - abs(inner_step), abs(inner_step)) - rounding;
        if (same(beyond, own) && outer_step * inner_step > 0.0 && more > 0.0) {
            more = min(more / abs(inner_step), 0.85);
            slope = slope + slope * more * (0.5 + more * (0.5 + 0.7 * more * more));
        }
    }
    return clamp(slope, -8.0, 8.0);
}
#endif

#if SLOPES
// Change of depth along x and y over the width of surface that a pixel shows.
float2 slopes_of(int2 p, float4 own, float2 focal, float most) {
#if NORMALS
    float3 normal = ms_sss_fetch_normal(p + origin());
    float least = max(abs(normal.x), abs(normal.y)) * 0.125;
    float facing = max(normal.z - dot(ray_of(p), normal.xy), least);
    bool valid = finite(normal.x) && finite(normal.y) && finite(normal.z);
    return pick(zero2, normal.xy / facing, facing > 0.0 && valid);
#else
    return float2(slope_along(p, int2(1, 0), own, focal.x, most), slope_along(p, int2(0, 1), own, focal.y, most));
#endif
}
#endif

#if PASS || DOWN || UP || DISC
float pixels_at(float depth) { return PIXELS_PER_MM / relative(depth); }
int profile_at(float4 own) { return HEAD + STRIDE * profile_of(own); }

#if DOWN || UP
// ---- half resolution -------------------------------------------------------------------------------------------------

// Weight of a pixel near another in depth: (1 - dz^2 / split^2)^4.
float nearness(float4 there, float4 own, int at) {
    float dz = (there.a - own.a) * DEPTH_SCALE(at);
    float f = max(1.0 - dz * dz / max(SPLIT(at), 1e-30), 0.0);
    return pick(0.0, f * f * f * f, same(there, own));
}
#endif

#if DOWN
float4 nearer(float4 a, float4 b) { return pick(a, b, b.a > 0.0 && (!(a.a > 0.0) || b.a < a.a)); }

// Four pixels to one: the mean of those that lie near the nearest of them.
float4 filter_pixel(int2 p) {
    float4 a = texel(2 * p);
    float4 b = texel(2 * p + int2(1, 0));
    float4 c = texel(2 * p + int2(0, 1));
    float4 d = texel(2 * p + int2(1, 1));
    float4 own = nearer(nearer(a, b), nearer(c, d));
    int at = profile_at(own);
    float4 f = float4(nearness(a, own, at), nearness(b, own, at), nearness(c, own, at), nearness(d, own, at));
    if (!(own.a > 0.0)) { return own; }
    float4 mean = (f.x * a + f.y * b + f.z * c + f.w * d) / (f.x + f.y + f.z + f.w);
    return float4(mean.rg, pack(mean.b, profile_of(own)), mean.a);
}
#endif

#if UP
// The weight of a pixel's own light in its result: DELTA, and of each term the product of what the taps along x and
// along y take from the pixel itself by linear interpolation.
float3 self_weight(float depth, int at) {
    float pixels = min(pixels_at(depth), max(PICTURE_SIZE.x, PICTURE_SIZE.y) / RADIUS_MM(at));
    float3 share = DELTA(at);
    for (int t = 0; t < MS_SSS_TERMS; t++) {
        int block = at + t * KERNELS * STRIDE;
        float3 across = zero3;
        float3 down = zero3;
        for (int k = 0; k < MS_SSS_TAPS; k++) {
            float4 tap = TAP(block, (k + 1) / 2);
            float away = pixels * abs(tap.w);
            across = across + tap.rgb * max(1.0 - away * ASPECT.x, 0.0);
            down = down + tap.rgb * max(1.0 - away * ASPECT.y, 0.0);
        }
        share = share + SCALE(block) * across * down;
    }
    return clamp(share, zero3, 0.999 * one3);
}

// out = s own + (1 - s) rest, s the self weight at full resolution. The rest is that of the four larger pixels around,
// each solved from after = s' before + (1 - s') rest with its own s', interpolated (3/4, 1/4) where depths are near.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = source(p);
    float3 light = ms_sss_fetch_color(pixel);
    if (!(own.a > 0.0)) { return float4(light, 1.0); }
    int at = profile_at(own);
    float3 share = self_weight(own.a, at);
    float3 rest = zero3;
    float weight = 0.0;
    for (int i = 0; i < 4; i++) {
        int2 q = int2((p.x + 1) / 2 - 1 + i % 2, (p.y + 1) / 2 - 1 + i / 2);
        if (!inside(q * 2)) { continue; }
        float4 there = fetch_half(q);
        float f = nearness(there, own, at) * pick(0.25, 0.75, q.x == p.x / 2) * pick(0.25, 0.75, q.y == p.y / 2);
        if (!(f > 0.0)) { continue; }
        float3 after = fetch_sum(q).rgb;
        float3 least = min(min(there.rgb, after), zero3);
        rest = rest + f * max(there.rgb + (after - there.rgb) / (one3 - self_weight(there.a, at)), least);
        weight = weight + f;
    }
    float strength = GAIN;
#if MS_SSS_STRENGTH
    strength = strength * min(ms_sss_fetch_strength(pixel), 1.0);
#endif
    bool wide = pixels_at(own.a) * RADIUS_MM(at) * max(ASPECT.x, ASPECT.y) > 0.5;
    if (wide && weight > 1e-6) { light = light + strength * (one3 - share) * (rest / weight - light); }
    return float4(light, 1.0);
}
#endif

#if PASS
// ---- X and Y ---------------------------------------------------------------------------------------------------------

#if SECOND
// The light before the filter; only the pass of the first term adds it.
float3 unfiltered(int2 p) {
    if (FIRST_TERM < 0.5) { return zero3; }
#if HALVED
    return fetch_half(p).rgb;
#else
    return ms_sss_fetch_color(p + origin());
#endif
}
#endif

// A weighted sum becomes a mean, of the same total weight. Where weights have both signs, what is missing is replaced by
// the pixel's own light, for a sum of weights near 0 is no divisor.
float normalize_sum(float sum, float weight, float lifted, float own, float total, bool mixed) {
    if (mixed) { return sum + own * (total - weight); }
    return pick(own, sum / lifted, lifted > 1e-30) * total;
}

// One pass: taps on the tangent plane along one axis of the picture. A tap at the distance s on the surface reads two
// texels, which count
//     f = share of linear interpolation * (1 - dz^2) / (1 + (1 - flat) h^2 / s^2)
// with h the height of the texel over the tangent plane in mm, dz the same in units in which weights vanish at 1. Light
// that enters below the plane, at an elevation theta, reaches the pixel by a factor (1 + K / 4 sin theta)^4; where the
// surface bends away from the plane there is more of it, by a factor 1 + (1 - flat) (dh/ds)^2 / 2. Near taps would see a
// mesh's triangles: they follow the sine of the next ones outwards, in proportion to s. The sum is divided by
// the larger of its weights and its factors' weights times the root of the reflectance: no mean exceeds 1 / reflectance
// after two passes.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = texel(p);
#if SECOND
    if (!(own.a > 0.0)) { return float4(unfiltered(p), 1.0); }
#else
    if (!(own.a > 0.0)) { return own; }
#endif
    int at = profile_at(own);
    float4 total = TOTAL(at);
    float2 aspect = ASPECT;

    // The effect fades from kernels of a pixel to those of half a pixel; one wider than the picture is reduced to it.
    float pixels = pixels_at(own.a) / side();
    float radius = pixels * total.w * max(aspect.x, aspect.y);
    bool wide = radius > 0.5;
    pixels = min(pixels, max(PICTURE_SIZE.x, PICTURE_SIZE.y) / (total.w * side()));
    float2 axis = pick(float2(1.0, 0.0), float2(0.0, 1.0), SECOND);
#if MS_SSS_ROTATED
    // One of 64 angles a pixel, of a linear congruence in which neighbors differ widely.
    float turn = float(((uint(p.x) * 49472u + uint(p.y) * 37345u) & 65535u) >> 10u) + 0.5;
    float angle = ROTATION + JITTER * turn * (1.57079632679 / 64.0);
    axis = axis.x * float2(cos(angle), sin(angle)) + axis.y * float2(-sin(angle), cos(angle));
#endif
#if SLOPES
    // A mm along the tangent plane has the picture of 1 / |(axis + slope ray, slope)| mm that face the camera.
    float2 ray = ray_of(p);
    float2 focal = FOCAL / side();
    float2 slopes = SLOPE_SCALE * slopes_of(p, own, focal, sqrt(REACH(at)) / DEPTH_SCALE(at));
    float slope = dot(axis, slopes);
    float2 across = axis + slope * ray;
    pixels = pixels / sqrt(dot(across, across) + slope * slope);
    // The plane's depth a column and a row; in perspective relative to the depth of the texel that is compared with it.
    float2 plane = slopes / focal;
    float mm = FOCAL.x / (PIXELS_PER_MM * DEPTH_SCALE(at)); // of a unit of dz
    float facing = mm / area_of(slopes, ray);
    float3 elevation = ELEVATION(at);
    float least_sine = -1.0 / max(1.0, max(elevation.r, max(elevation.g, elevation.b)));
#endif
    axis = axis * aspect * pixels;

    float3 result = own.rgb * TAP(at, 0).rgb;
    float3 weight = TAP(at, 0).rgb;
    float3 lifted = weight; // the weight with the factors of elevation
    for (int side = pick(2, 0, wide); side < 2; side++) {
        // Each tap is added once the next one inwards is known.
        float4 outer = zero4; // its light and weight
        float outer_sine = 0.0; // times the weight
        float outer_lower = 0.0; // mm below the plane
        for (int k = MS_SSS_TAPS / 2; k >= 0; k--) {
            float offset = abs(TAP(at, k).w);
            float2 along = axis * pick(offset, -offset, side == 1);
            float2 whole = floor(along);
            float2 part = along - whole;
            float4 sum = zero4;
#if SLOPES
            float below = 0.0;
            float elongation = min(SLOPE_SCALE * mm * mm / max(offset * offset, 1e-30), 1e6);
#endif
            for (int i = pick(2 + 2 * MS_SSS_ROTATED, 0, k > 0); i < 2 + 2 * MS_SSS_ROTATED; i++) {
                int2 corner = pick(pick(int2(i, 0), int2(0, i), SECOND), int2(i % 2, i / 2), MS_SSS_ROTATED > 0);
                float2 away = abs(float2(1.0 - float(corner.x), 1.0 - float(corner.y)) - part);
                float share = away.x * away.y;
                if (!(share > 0.0)) { continue; }
                int2 beside = int2(int(whole.x), int(whole.y)) + corner;
                float4 there = texel(p + beside);
                float dz = there.a - own.a;
#if SLOPES
                dz = dz - dot(plane, float2(float(beside.x), float(beside.y))) * relative(there.a);
#endif
                dz = dz * DEPTH_SCALE(at);
                if (!(same(there, own) && dz * dz < 1.0)) { continue; }
                float f = share * (1.0 - dz * dz);
#if SLOPES
                f = f / (elongation * dz * dz + 1.0);
                below = below + f * dz;
#else
                f = f * (1.0 - dz * dz) * (1.0 - dz * dz) * (1.0 - dz * dz);
#endif
                sum = sum + float4(there.rgb * f, f);
            }
            float4 tap = TAP(at, min(k + 1, MS_SSS_TAPS / 2)); // the one before
#if SLOPES
            // The sine of the elevation, without what may be rounding of depths; near by that of the tap before, as far
            // as it was found.
            float rounding = own.a * DEPTH_SCALE(at) * 2.3841858e-7 * (2.0 + abs(along.x) + abs(along.y));
            below = facing * (below - clamp(below, -rounding, rounding));
            float sine = below / max(offset, 1e-20);
            float gap = abs(tap.w) - offset;
            if (gap > 0.0) {
                float follow = offset * offset / (0.0289 * total.w * total.w); // 0.17 radii
                follow = outer.a * outer.a * outer.a * outer.a / (1.0 + follow * follow);
                sine = sine + follow * (outer_sine * sum.a * offset / abs(tap.w) - sine);
            }
            // The area of the tap before: by the slope from this one to it.
            float lower = below / (sum.a + 0.001);
            float bend = 0.0;
            if (gap > 1e-20 && MIXED(at) < 0.5) { bend = (outer_lower - lower) / gap; }
            outer = outer * min(0.5 * SLOPE_SCALE * bend * bend + 1.0, 3.0);
#endif
            weight = weight + tap.rgb * outer.a;
#if SLOPES
            float3 lift = one3 + elevation * clamp(outer_sine, least_sine, 1.0);
            tap = float4(tap.rgb * lift * lift * lift * lift, tap.w);
            outer_sine = sine;
            outer_lower = lower;
#endif
            lifted = lifted + tap.rgb * outer.a;
            result = result + tap.rgb * outer.rgb;
            outer = sum;
        }
    }

    int mixed = int(MIXED(at));
#if SLOPES
    lifted = max(weight, lifted * ROOT(at));
#endif
    result = float3(normalize_sum(result.r, weight.r, lifted.r, own.r, total.r, (mixed & 1) != 0),
        normalize_sum(result.g, weight.g, lifted.g, own.g, total.g, (mixed & 2) != 0),
        normalize_sum(result.b, weight.b, lifted.b, own.b, total.b, (mixed & 4) != 0));
#if SECOND
    float strength = pick(0.0, pick(GAIN * min(2.0 * radius - 1.0, 1.0), 1.0, HALVED), wide);
#if MS_SSS_STRENGTH && !HALVED
    strength = strength * min(ms_sss_fetch_strength(pixel), 1.0);
#endif
    float3 delta = DELTA(at);
    result = strength * SCALE(at) * result;
    if (strength < 1.0 || dot(abs(delta), one3) > 0.0) {
        result = result + (strength * delta + (1.0 - strength) * one3) * unfiltered(p);
    }
    return float4(result, 1.0);
#else
    return float4(result.rg, pack(result.b, profile_of(own)), own.a);
#endif
}
#endif

#if defined(MS_SSS_HLSL)
#define MS_SSS_MAIN float4 main(float4 position : SV_Position) : SV_Target0 { return filter_pixel(int2(position.xy)); }
#elif defined(MS_SSS_WGSL)
#define MS_SSS_MAIN
#else
#define MS_SSS_MAIN layout(location = 0) out vec4 ms_sss_out; void main() { ms_sss_out = filter_pixel(ivec2(gl_FragCoord.xy)); }
#endif
#if !DISC
MS_SSS_MAIN
#endif
#endif
#endif

#if MS_SSS_STEP == 8
// ---- light through thin parts ----------------------------------------------------------------------------------------

// What part of diffuse light that enters a slab on one side leaves it on the other, parallel: the cosine between
// the two sides.
float ms_sss_through(float reflectance, float decay, float thickness, float parallel) {
    float dark = max(1.0 - reflectance, 1e-4);
    float R = 1.0 - dark;
    float y = decay * max(thickness, 0.0);
    float x = exp(-y);
    float gone = 1.0 - x;
    if (y < 0.02) { gone = y * (1.0 - 0.5 * y * (1.0 - y / 3.0)); } // the difference would lose digits
    float slab = 1.0 - 0.85 * dark * dark * dark * dark * dark * (1.0 - exp(-0.8 * y));
    slab = slab * dark * (1.0 + R) * x / ((dark + R * gone) * (1.0 + R * x));
    if (!(reflectance > 0.0)) { return 0.0; }
    return slab * (1.0 + dark / R * max(parallel, 0.0));
}

// ms_sss_transmission of ms_sss.h, with reflectance and decay of the kernel: light of a lamp behind the pixel's surface.
// Unit vectors; entry_normal: where the light enters, as a shadow map with normals holds it. Before the albedo.
float3 ms_sss_transmission(float3 reflectance, float3 decay, float thickness_mm, float3 normal, float3 entry_normal, float3 to_light, float3 light) {
    float entry = dot(entry_normal, to_light);
    float parallel = -dot(normal, entry_normal);
    if (!(dot(normal, to_light) < 0.0 && entry > 0.0)) { return zero3; }
    return entry * light * float3(ms_sss_through(reflectance.r, decay.r, thickness_mm, parallel),
        ms_sss_through(reflectance.g, decay.g, thickness_mm, parallel),
        ms_sss_through(reflectance.b, decay.b, thickness_mm, parallel));
}
#endif
`;
const BINARY = 'H4sIAAAAAAACA+X9CXgUxRM4DPfM7JXsbrK5IJAAswtCuEGUy8hkkFsRUfBGQAhHEu6AoJGEQ+SUcKiAB5sNKt54ghLccClyyaWiokY8OCURQVHBfFXVPbOzAf35/t/3e5/veT4Udma6p6e7urqurqpmQyeNkRhj0oty0yFyYaFUOEQpLCxkQ2zwb6FUMIQxegDP7YWF1gtRheFbbIiEBa5C8QeunZFLh3klFWJrBfRSAW+pwPwmfMxWSIVKQUEB3MnGM2srjC4K8MLJL4wuFVDtAqOOKGG8dfwatlRgdLMAv1E4RKYvSfS5AupJAbWD/SvAURXAk+nT8Xo6VYcnyoTximKz2xzM6XDFMFus2+N0ut12L3N7pbj4OFecLyHR60ry2iRnsuRIYbZatVO9iZJHrlNXltMSpFRbenp6vfr1G6TIkhQT4/XGqKpis/lVe6Ch39+o0VVX+RvDf+pVfr/apHGGv6HfZpfGS3a7XZGYx+GCbunls1q4nbe6HGOyx4ybOE1m7sGjx47OHz00b/SD2Uxyjp085v7siZNYVsywcWMn5Q8dmz+J6c4x2ZMmDR2Zzbq6xgzNz54ItdkN9omjx46cxLrbRozOy2M9YmIlpktuW/tOnXvFvlitjIemXcxXBH+YO1eSCxvSpe7LDSiN+CXz2+QsVdILc1QG/0zUi4psvb1MVfCivexSFVVqL9vgh7WXoXG/TZV1SWf6ewvhdVXxzcJm6rrhBV8Ob1O1uZ/12GIA2NJ0h/HJcpbrt8OXWHdo3A519QY5fofKVBlbZ/gReK7CJz3QEVeO3wm1Oubo9hy/i185c/wx0N1YJUu+4n+q0pKxgE2/qgd8wdbda4PKbvgrw1+PR8IeSjl+L1aTArL+A+vpleCL9gzZA7e2HPyyF5rAEWbI8A5UgZclv1v1+hU3dIJ1ZgnYx87MB+1hs5GHMjwEyPzKenhlrI8fd0OnZP1P1kMMmWB3DL7rEN+FMelTJ8DXXfh1rN1cYYG4TYH4rkX8z4VqNstyfSu19OmTCNEfaQLiuxYOTNP3Pcmvq/kf56xb0gJyBoMp82HfYHQwsM4s2ePAbvvgS/geNdYSOg6D9Ll1GIsat0qNU+O6MfFnWFogcjM8IKf5E0Rp4exW+giv4rG5a8KQQNKaw1BWHX6bkqXaALUCMHroSuzYgE+PzcvV20zszGD69Zgb/YmqD6omemF9uN2ADLE5ABFshnmcl7VPDdvgw9BuAk5pgtnhRlmlAWv3GE2BZQSIfHHd2sGf6tEXsobBLTVSGN1IKBD1imR9BdvUHbqkAiyS+Fg1wj7jlQotaL5epQ+zfH3EBPr8y36ZY4/sVl1qUg6MPsbvhX54EUheA0jJFiAlBhCAUJGglaImA7RSoCdyFi4GNUmXb/bi2kz0QJtJWDVJtSEqywR5wrs2gIVYCABLdMOYGfy15eju3mmBFL3BZDVlAkxQYi9/spKlt/HLMk4a6wUdTtYl6rhXJSzCbiMyq/C/jJ3zYZPJUBt+ZAKFTU3pCS/AjN4sMF9NztFb8cpyjh9XD4zB58Yq8EXoHXVZxo7CE3wXLpPUlF40SGgyRU3AJn0wRMn8PqDEj4wjkZSjt9Sb47B6pZnfSYQXE+BZg8kBGTo7CerH9DF6lJijt+E1FYIIn0pjKgjgkclIEJMR8Jk4m6wmAHiToYNQX7SoUnEiwZhPgI/Dxab6EHHML2Ov3YImIIq6OVWkheNRPWaP/y8vIEJ4j16Iw4zVz0g3wq+xnlpi9VjsTiwQQ78Xq2InA77ultqiv7F+GT7rVOUcXdM11QdwqpYmBGL1atYjDSqrvdMMyPtjzWYk43UZWusN3Yo1ugXYDQWKBy8l9z6HzVYoPSwVmPyhgkV4koQ8iaadwVoP2PW/H87Rqx/uTTCSJniJls+QOXeyc+5E/AN6A6ysYpmVMwG+8IZsAYc+LUefdiNxN0d7ORVeg59k/rbP4G3Qwhu8BZieSCMqayav7RtwbvS7qGvOG3BN34egc236B3Ldn/d4il4NsOPcS19o8yPGIMDlfJyXZjBE58bAvzQii48N8uKyjMUpbSa7+Pe9CjEi/dBuBrzN7Y/Dtv3I++ycUcJqjMNvbPy3TtpU7/+uoz+9h/1rrVtpZnBGboKf2PZyL/jxtJe7cQhnWSC8dhGHcDkzQexwwydsiDwAshyYdaUnUiyv7kGuHacvhN84wG0o86gOKnNjmVuNVWN6IsoKXMQSppdBZ/3MAgeAGVtwA2uU33swThrTU3MiT8ye38l/BvAu32Lp8rNP8C7vi3TZhh+y8c9EddujuLE9VyclgzekWhoqEmNXrdhFlTtysF3D32ljeecr8fE2ORaBq4JFJK7vnDG4nuRC+WGpUAHp2FYgPQwvNsJB+u2q1FxJBXlLgnUAopWEPNSlyojS/hhVaiarADkYhr62qe8QNukHBAXOC3/vS4PXXaqzj99tEbZsCEMlQ07vjqCDhjb0DcRu5C1uhAmK5eiZ5vd6/ke5qjSTGwXwvkgbBI2Z/NIfBwCI95hPqjQ1dmMJPGX+eCCeG4G4xmwExg19U91pMCoPNqUG7BuBV8V1WzP++tjPS8u1ULcN9R851X/DB1owpNr5ZwOutG4bsmYe/WiFC7h9opqoeoanwb/xwNTFAONxYSNFYyAJF11U2suHM5C9Wm+RKsBb+LXk13p+92DyWfgaXbz2OXwtkFT6bkeoB+xW9YWAGjrXw3CZmgRPD2Wg0Ntc8QV8KlQLJHeU92VcAbLshsHj57WhXuOsudJ4TbcpbaiJpX7sQkIpgIJ37qH28vKm/HoNdPQCfiru3UBMR/kcXiaBiJcUCkEnVkAtgFpSaSAJnsCDqgwArkLkSQF+o1/MAC6El079EF/8OE1dlqsxywP2jjIShblNc1Sn/govDcQu4V01phfqwJDsuPiWN12OL4cH0eqjS9X+eEd4jrhsywkouodWNR9oAOh7eYbqQMglUWukP8jwdgQfAHJ+O74BnfkhAwALBBYGYHAQPhCgswEawhEYjYSjUfQM7C0OwKkfz4AyWo7wSI3lA8MvefHf5AiZB41ETYYOMze0ryCnm+B30sp3AprIQKYdagLIiwpIBg6gAJfXQubnUJM3hvwO7HQCQHwHzogDLrbhRWK34JZTf9/Y6+1OlsvhaVC8O8P9vcMpIdOkJQ7K1cOCdVZJuQFZEAIZIe0JKAAOid+kdpSPi0u1o3xaMmBD9DDA18O9qsJ/c4izBBziDmAm9SBJzgnkCKgJKn7PLaUPRUgR57C8pXuQ4wGLxHZs/hjz+f/mkzFUbwjWi/l3DiMjqcROxWzspLiISPKe/TSXehbVLYfRLfOauoKX19wwiDfngHZUSzsvPclHGEWgQWMEIROIPU0myd2KOWSFpALx4N/HGhlCqori+RH8WA7QY0ME4X04uZD3ISKCyCSv6a4ehIo2ouuKYJnQQezhBZbDv1Rc8uRm1gGBpFdZnun80Qrp8mrF0mXVNhiPoN8af7QOHokXjjNCFt9Gmgt9rZSDQlbGen47F2/1ZBIX+JPvcHLak0Z8aDldDlFla/t3wi20fQtUKOcVigBv9a/4e0G8PraIrssFPjeCpnvB432RXh2+vM87eM/SN/B+gMShAzv0LSQuZ0OwVUkRPlos23CJSQ/LBUg7uHFCRuGSYcMXYTLKoWEVqRQuFZtgKHaURulZasCxMUKhBM6lBZydFB+tOzvRP1VZj7O4sVunZ24N9fh2CTAOg6KHfJXYmYBLdQVDpYAnHJMlXNgWFBZNODYadfjnWQDRORUvbUbveHWb6gDq1QjryW9igbYca/mWdpSB9ugtclTFfMynbikSu2rFDtAgaR0kCpmLEygqXGRcVAg4kF1lBJyonZOIUZ4RYAg5B1IOPXiG5eWQ8s44HXcZXI5eTA/YurcX4iwQDhDfSBQgsWCZ30WcPgaqujrKKjbfDEmlTMRreUeQ3tGYAg93ZMAdDft4BnTQccNdX8AKJ2bE0vDxhQwYTj5NCLRufxzpfDpv8EhGR7mF6gCShuqDyRscgnhBAx3la7iNiQSMCFTtGyNyhBoDfNzuj4WpiIwgYF92g+v667TlEZSwbyy5knCixoRqtrUUNTWHGosT5EAe10h1cQbsB2XRLwF/g/4jP+uYg3YevGb6tiMSjmA5DkHRt7Ec3hum7+MFAdfj/ImLy1xpkTvBsgEKwI8lzo/dhxRZLnQXoMUCqgzR4Z8gmgxZn4CSdkOv71ZlwZNuAJs0XGfAfNI2+m3mcHVoLXd9wK7ag76jiC4loggG73dEoCLphZOuVA3Wg98ZkQldkcuYyGVs5BKVK1ekWVl3TlgvbuPKg/iBEDxUptR8GASh1FZaYjbk20+4TfXtkfaUtFDAHkSbJKw9D77kKAl4Q4E4NTboR4nZsxomLwgYG6d6Q6o76HeTkhxAymOIN2iWAyIObH08KoKqG+XEUXAZo8bi5XDVIuO48MkQrBeBCLyDUq+jJFSCpXkqqYT55urF770JK6DomuVL4aGqL8fydDRb5b+5HKjAVPcMSZILEYlQFNCZbwEO18v0VZJfwnn0QY+dPYhvyrqtF5R01J1w6eiRFo+ijUQFqOxgbRdgC+opUp80P1IiVLdRc5HxiSrlkSavy2N0R04eciwJrQDH7ZJi6P/7ZFOI4dIJGbQUwQ0PPk62aqs2Dj2EYiDvwN/m//joH7s+WvTbR4ILAI23sKmaDKEiUgpsquvJlTP3LNv1yfIPxbMiy7Me/FFHYnUtBCc7zDmfKm4v8NtG4nYO51dtIsztsXJoOYNzNxXF6Q3E+/Xt86kmmo3PcsaGvG8nfzoeLj/gl8US5681xxGMsL0dltJyAwgWXn2F4opI8VzZLF5hFBfJZvEKiQaYIQa4gfPTVMHpDxOnT0cJRjy5wCvYxO03nJmvw1Hs5Nf78LqUA6oKr1fw62K0bwUjX14b6dhCo2M7zGezN5hDlXNobWTv2bPZslR1pU/AlsZ7sUKmTrlEpzbwW6PLj/Hvr5NJ4tJjDfkgoKDhw4v6vcKNUQwNUCRntyc6idj5zGKr3Iloi2t+n2xIFYr7XQlIqFIgcF29bPuFG6LRJNFcIT2HFqUL74C7MugTXjlHcKZpz/byFYBaugIvqXYcBtqrVCddqQ6QjC/fs9myOMoyRtqsmuNntP8TkEg/QUXIlIZmOBVnoVwgm6pG09yAy1ilSAI52QjEeIXGBB+LAZaPHzu3vOaaBWHAN8eoD70Dlcg30/K+I+r94zXfxy/CqidipKIIiC0Ap4dWHiNhLkbY+qKamX0Z6bAjcYoB4hRD5Ao1RgCE3wO/aPv1gDLt9M0W/UIy58GJj8H3WCDuJhTu1TgU91xqDEo5LtXLwUyfVL36b6QhuSxg9pi9dfoWGy2rHqCEvGk3UH439AVq6hVouPIAhUeLacDb0zCBS9wcD4SzD06/S3Wj7dJl2C6N8a5aTh+Psl3CyIBZACe2++bTPNryhZUnBmqWN83h3fM9StMeg/TT71VdzZXDTQPx+LuvacjvMzbe+CwQ5XfiNeiLMGwHUfrYvH4wMKcaOxZUYBi45HfgXW8vWe2JSuDOHtqbElCIa+RPxCZS/aDNESI3lRt1kLEPQHPlN1EWgS42VY437QAkNQaEVC6sJC6jIr1Rjup7ly5JeuGFUhqKijEgw/LRcSNYIFG01kyuaNoRyG4Mr50ATXngeTy0AzOq2uCrNvhV+Nf1TFhU4jIDvqYmbkRLCS7dGByhC7vNgYjwiB2PE5iHNkpYc75HCKIoFlM9LyER54OqEzhhfo6vmKo40XjpJPO4C5aZsQRj3M+4nU7S+r0PS9Md8NdYihdYbsBpWsxhtcNkyv5YsScUq8u4BxCjK7gH4/K7sa8xuE8ij4GKseIqVvf48YuAaS4h7qm2DDkZENDGcQUqw4M28AGnfrgZCsgdfQcJseDBWnyAyGOizrQcve0Yv9ewEsIMc1sC0lHgIcJozbh6EmcI0hJpLmrcPYAnug3kKIduA1x+Yv7lJMBFqxtrILYvv2x1O/Xy5oKBOPUNzXNUD9F4p74Drt1A5/gt1gg2h8ffctZbjNfnOMNdB9cqsoYVeGFDcgHwQpj1SeMNrMXaxc0BhKpDcIpY4hKx8HwFPGf64T1CPQI4dZ0BF74OCn4EVizTjxyRAEXiSc/YMBU3WrA1NTYHltJCW45hYgRij4Z9y30sCuaxwlDmNJ5fbIbXUo6YEd4YTZeBgqJrqFRjHwDajTrSa+LFeLP6XI6Oqsc3D6/4GnE2k/c1DfhUJ8JCSvPH4ZNk1West8f9CfwS5lhdBmuavelPghWEe3tv+lOwdqq/Ft83AYIBKt7Os70n8I1AKEtX4x7H7UCnnqE3QoD7dHuPNLJw1MYJJduiPxUnkV/Wgcvd/LIu1k8FmRXaucafhj+qP111NlU6+uvh3RB/ffzp5m+AP8P9Kv6M8vvxZ6o/gD/5/obwgtzC3wiI1GmQ52ycVNGyt5OpQ+LXKlCnIfDoCDyirYh41d0LrkCccPfKEfVRQGzILw/BZZwaWM5f9ncEEc+OPVdVXg7jUevyS1DU1Dq8XoOOSGWR8tTnZUAMU3lRPaSDdqSDEcULOFefNF4xA6ZQjc8XHQHqmM5fq40UEQmwKioCMfLxK6CStXilhI7kLpCE9NCuJiI5tKvJSA3tagqvXMXQLMyANxU78gz8BmLdi3a6ipwg2VsQ3I6ivgyV6S8tHtorQTYX2wdEqhj9BOvtd3BrGu0xuVCRdYMQmAdIqafmIbancvMYWjBiga81lRmwCDcXGJDkqcj9QDWEdQSUjRdD09BULPwj3o3FvaJYeFzsyCG2BxKPi+gdiZzQTQm3Y3EHkzw13Hqb3nzLDi4l3GaKodpOpLwGeY51n5DtaC1SyGIU8XUJOEQN2jUk7uuLJpUkTbqIGuNHOLFsEXBHbAvIk+EviAVAZZqDBuHcGPJ7uCXIFanmUd0bS/0eGMf6gBd3j1Xv8LSAx6IsenCJeNKApgMDyDcmQRb7YsA1yPbeh/ZFj5M5EreuFb4tpeRxcRZ392FiZRQXPaqyfjhAg6AjcxuxA4VNFzI6kImoYc9Kow/6MOroS9zzAQEzFd0IHGRYI3pvJ3o/6zGEjMPc4nLg0jdBfVaRPQBmVKB1xlVMGwhDaQH0cCnGnQr96Ywc35Iic58OhA+7vtAD2mcOklWYBhPqKAAiPiDaevJyiAkW9jKFQAURNj8Ql4ONq/ATj1/gdiGxqyrdZLgSuKEC0WlhN2J4LzZLOY0jhydmGsB8+EQ1V2AbRPWLptnJjqOGJ3Obmh9UPShsoVnLH6/G0iZvPEpRoj5gth1eALyNV+MQseMEqtKYHfjjEOKk2FVVOGLiSleQKoAoti+DG4xa0N3hDCD3PmFDykTYBjNwKQECoQfO0wTuNfyRnM8pn0KUDV6uyuC9RpDSVqsLO6gg1YQeEuRrDsF2xSG4i2W7rRC3NdH8CPNumUyxx437tThVDtytQBBbbEWGB0EM9cNSoBfiQkdfMpAicOUX9khbr8ailOgWi4wvRNqsAtmMDMAovMagMO9CA5AgKGRsQV1CHtOL+1/IFgNUOLiy2y+jvp/7zoUfuuAiIC6J6obqMFFE7CKgTP+u300bEoBTfHftsv1wd5Fdjil0FkQ8+ZyXWU1sQji6eLnVRDfUVjQWQrMq7VCptrQALF3fMpJkbDRkTw5a7lC/8i03HqPMiwzcQ/RKKCTYDKBXLPB17qpCXmwoZNloDaLy6ULi4cBpdRBmor5JS07JB0hCC+bKE7iOrQHGKvk5qKDaxHok9cEB5F6m7zhqfAdoD/YEvYkCsvCFgentJdoLxKkxhF5mw6hs+2hvzk2oFK/a0FAHTA7V7QTVVwKVbSiU7eOPEtXEUCAJRhKUzPughdI6zErJapKlIJBSUhqoRQ5JZPhGm88t2EKJmgKtrSs0W1OTzdfCoWCpPxEHUQsKop3YyCblQxcpaNi3CmuoicEQ/gZLVZ9vH04ZN2EChNwmiBL8wOERPnaaB2SSMKVRpCHW9zhnUOiKQBYKpCQW584yuwzsrsDiuGNFQW4EIG2BpPeD+C9OcY80LtAiZr76OAmZVsFegIZQzIa8HJcRzDdpmTFcx3WJ1xc+wVUmn9UTw4WLxUXUBRa8wvVmZBY3UxOwhBuhWM99MYyWLi7mLUW2+mjfFl1OpV6k/Ct4gQCfCq1j7wTbdAHoAuSvGftv25oRy/Qw8y57zx59OCpnqPjEon7NSro9/lnj4+5WCUglUChWY3Fvi0aeZfQXxrb3Md5fi9+MHSgGqn9i5D0F4sMs3EzgdHnIRQg3C2A556FPYPRAMshzClYEDabbyYXBTnd1adpj+OW9/9c9TerynbzLAzjAbzF7LuknlvCe74vq+RUmDbtsUFUmfGksM3b0co0PHXbaiOKvxIRaHGWcFkcZl/svSbJZ/KDthiGORBxQZQIOv1Nor9BiTpwsS9CnQuKjb/20u86NOFYkCHl+J0dbRS/EXS5gQA40RvWGJnxPEMl0ooSAPmbAI3FrS5ehh2fnYUfsUdYZXC4o+PD9NCe+Uuwg5QyaRbHKyf2kCarIWRXukKCQsLscqupPA9NQTHEXOYyTfu2Rpetyb5bsMrFTuUAqNNziJI7hZMVHhCbnZaDaRBJl8ugLIP3IE+ZIRwj9JVQlVNIttWW3AX/5Y7JCIMtDb0tocxzlcDuQ4gDjpnJux0SRA4gWXFnopTNEFkh4GAwFkZTTqnLpqUSJ7ES0UOhB25lEmO3uIVHPgYP0RPSOdxtO5XzPQVxxHielqXICjR3qiSe+XeQN/6EN2Kj8T0SMCSL2D3xUryDSdkqQNrlHwJWGKghxV6HK0DqwtnIZzdN/R9OD/hF5LUADpAPQm7HR5E68GWXSo92XcTn6+N5erlEpaLLhBkx40cvdpOAujpgcX+nE1UxKQ9bkBJMiZRNjingrR26plJY4TojqE/YUuEQOwamRmkBPcdAd0R8LV6RTjW8vX2PSgHi0XQKw0vTSJTUWKaffLiQFcfgTB6IgKteCJXlABYThefHHS+pYAIiesZsGOBqRUlxeie81+VC2kUGDDLgMexU9L1ZAvVeNZ0QfaWQ+zh/kaP7wbHEN/lCTnPST5EKBgUR0VzhyONNivj1YJR6FrqfpYUASyLkc4x7gt9jB98jSVClhBmGp291LoDe1Z0VthL8UaRMXqxJBdlU0pJgNvaXYoKUCe6FSYDTDFwdCADfWVqH2FMK9fJKq0EZM690JrCAAqzCGjGicEJrrK5bYomW3FfAO17tLL3qYxCkPYZlpAAQo9iTfcTtppp5gqNRXgT1ErdQTEgSkTlaolLZKcSq80b73Xpgtj3gJL0WpK8toCaQej2inU1YIhlSKQnSM6ibBB82uJKyDzBMLzESmAAPJ9xQ32nERNpYGh3JCDEEWqiO5C8SqRI2IagGMpZAai0sIe05Vcow7q8wWgm9ykhbw4JrwRHgoOTcRWN1Eq5FqIjI7hWzvzgfexMkykGIOccWgvKpEK1Qhiqdw7l4YL8JabMChGClDQK6nqIw7i9ss7wbsaQEko8B60gJA7qBeH1pA7o2KHV1G7eQ2+j9wBYGAYTtkxxe0XiY5PhAD8IqgjNNEGXcNlPGgpRpNNQbKeNUY/Inj73GEscO8w3+ILj+QFZrcSG2qtzTg5U9Eg/uAi3hNnCiNKjuuhYJ+L/oHe2g3voRPCG40ALVGW3DAfRlKuC0o4YJKhAigtKJ8wjfkvJ1wjKrbRJpY6KpDjTeQwcIWaR8jmuVBRSvmlGAdgwNS09YVQBgTG40xwlivmOzQXN9INEzxjUI4mKBFOBTsrYEPaH1BA5Pke5q4oXupYrOTUCBZjViKudVnwQnuufyMsX0pZARAADsIQAIBqI4KD5yRwXPNxeQ+6CNo3qgK74jFuUMmzR5wCtHXSTgcGhH1vv4hNwC4AjHoceESig357Kouo0k1qoHuQjp2dbvr1wtbGox9TiJ1CiTQEni2cdPnX3xb8NX1oeFiQxa3i6xqnNtsFTfgolrG9RXVKhpCcWcPntdoXPiBuoRmRuIVn07uEc+h7l4aj6ZFEtYSDIm1ymWKrEaIBM087psId1PgWlX/oPjjC2I0HXHaZBPeQ9MCcg0NM5r121W5k+KzfOMccUZ7TaFE4pYtsmH5gtw9LNKwcOrgLVxccNnujiHZKkg4nOIKxvPHHwBoIcn5nSg74SMuypEYrpKoTU+5tK0IaXtPTWkbJW3+9iHhZecw4TAka00gxhLHJZcGYnEjPcZ0KhjOlQNVrmHblF8iJ0xh20RphuwqzjSLuO4S4nrFH9NgER+HLkRJ7LoQvHXhw8Tdrn05HKBKjjB2OHEXkpsI6RnwidhSTpFk8dwtlDmB2jaMarD53SYFsaKcMWG4QYlTVhK9DNFbhhzCsTsAJ5NfGxDTQr4vhZXBBGOVFgQtEz8G3KtCpc+4fCEuMQHNKRW0wym0T4PmuvQV+1HQE4qp0zTZlWtonifrY0+SQ9cjAZNQ1HCpcghGACKZb5VoVgEJmBui6HkEdDZ9rouMSbxnqUK2dKFs6RQ96SV4Muh7ipfvxm44QWKnS9/9xscMZVOXfvi7E2TKBLHHn+P3wW+FijGEtFOQqE+lKQgoubgJhu0nwwN3PkgT+uFf8M0U6GYtNDj5a6sp/lS4q0MGDwREoC7NWh01MY/MVPxbaajC8wGBpphsbL3EQ73kvKhHPgQgwlmtk6dXKxOokQriODoFk6StD/llAZs01IompAHmoYbL4Ya7DjaoHVIVZEsccibgAD5uIbVw+KnJCD9Jdffk7lq4h4KgIxsrfQWe14a3U0nAdFLb1HTJ5U07eeivWxgAhD1AUROpZ7VpTVinlchvkHu/CNzGQDmaudrYs9pqKsZYpqp1sME6+gyjzTQAfioBvS6RDuqnWH9OggIu4SvAzwnwo46raZaOJ1pg4oah1lbT+JzSrKKwZl1UIAVZnBeFh4bliRVulvewW0KbtvHfEHc7VOgR3cu49pwY1CiRRxDBhHa0nLqcE/Bg9I/qvskIFVTdfYzhw1JApKXma+IfhzZvHYlbLX3uCl9eDoeqgpgGUmdaDr2wDtYLyEQyTYuYBMVfh2L2CGVS8VmqmobvpomHFE0dR5BPoI7A7JOgIoKpbWS+UshEZbi/b4TRY5cCchQC2JC4FS10iT3y2QsJpXjgmG4TQWXQfVzUPn1usQtXcC0sriVoIsNNLCIlaISockUcuQZK5BcucfkHJBge7VOpqbLv2WjSib1mJB1xac9GHkDK8DR0JdPJPMIpkOI+JdsVDNjCqA5LwHzAZthcgULDHAbs3K/B1pUcCm3coRAnmT9HCIgr+oEORHhvlBMtyTbGJkUrg5rnPZlVSpHO7do1KQ8KlUsOgXhlE1KPEwWtWM6hLC0T33dzmTZaioiFIbsFwgKXoUuLZy+obqXAvwEyboy2dapeYzm7EUJuwxBEKNxU4aNXbU0VFwEArwgGLgvnAXZNxjoJ7fZH3NSAzSJW/Wb3yARoEHcf5gKWVOAtlKdLlk0VyfTPk60zKlmXo92EATobRoR+C2v8WfjHO0Kl+G/wXe5PLiPNxa2gnhhG7tS5p2z1pepqJ9BiYLWW4cRw92FYT7jG/JbwOGOvEtVrAF8cbpAE4vXdm/bDenWKL6neHgEf7fnH6zuQf/HnAGnxcN/HXwBLwV0wX5rqyqO+eI2+5AUS3jR2PGUrCXMY4pqs1+6LZqT19Ah6lGipBJ1L1OUp/iT99VZ+nx7rT4YKKbDMa8FvbfgLBBioQcokoA5Jr/rrArXwTVJrvdr181V/nvZMD6R1Vee+MAmYaIr+yNfPfvUQME5Yse/9+vUv03DN1u168INtS73TA3VfQHLyAtCZOvAQ3wnU8ddSk5EXJHMhpw5aUSU1iba/1LQuMii0at0uFLEAfZwAwFOliQHftTLrqs5R4dc2u6tn7vsRaVBcrcsM+Y7TtKar6cESP72eE0hUE3rzEG8yjZJ1IxhIj9gF+FXooyzDlpFeipZURxAD2OL1Q59+B7PmIF82j2X6PWJzRrUJRKbw6higIRhaHWuQVCYaEJ7qWddkkZMa+TQIvH/XGycJvFfoVyqIMa9NS+i+uZZoMgbylXB8pW28coO+kC/zBhf/XSd+941Sbesj8PLbuy36+Z3g7x+u6+J36C5uXdL3oTONMwcdVJnq6LZqJf75A0MBiPeDxLuPc+g6tH3rgBEtfC835o/gb5YImWDAzqVuPXiSYURWHSJpTt6qkCFQT0Y7nilDmhaDSOykUZiRNSzNvPHBTRCWq50ne4gONMAhQPMoocfiViQZGWlQxh6G2EfBKANgLYYSCosf/7HYBkK0gDlU1rkQKAGkfrhTz1+FJ9gS+fa6EWZ2eB8IpjFGgFWqCINOJf8U1RXBETL/RpI4oIKuE6PjvdVdE9EBEwWDRJXBCmOwNiV/Csqk602NrSIcDNQyB4/RsbVNKOEM4wBAvILVm+yvi4vdgh0CKRiIgTECaF5Y36nrA2mW1iMbTGpqmu9H0ufsagKBxRtwc4MvOQzEkKhnoEk6knh0hCYJNM2CGUYr9ci1xdUPBp+uj+d+1dGkya7Ww802fP/Kc2j3raHJqwUVxDXAH2OijZtakZtgoD5Mj9WOiqvWzScRVnqEtV1p7urDwMT8gRLph9HJRNvr4rx7ad8FX61jLh2vTgB1kvwCrYHmRO3VwedABVWY2bpqKo4nldJxuNUkfJYEVJEUkhQEagpuefeAr6G5HfQZJ9lHMHTYj+oMYVK6iTwuzA2TF0jEXft4zCND4rOhl6FpiMQpUEfgdVBJ4g2VBKPOAym0zcSJvkBMNL9hrDv0MxWESR+JfTHc273bnusKRzyLy76UA1VABE1tzvUBe2TKQ76vaJocZpwOYJZ4aJE1LFBLtyowbnKTRUMnOmLVAeSrS/NXR6ABfL0Qg3jgvbpCg4mxTGkoooKYc0L0xyY2KugjddE1oS7Mn60nFKHUjD6MXFewzJHYB6c1G014HNAv0CeIPcekrffbSWGrw0GC3bGHiIk7+eaIszdoKUBzyO+HeuXmXeJIohKSxPDeGMsLS6y2GooovOKMRkWimMzK70CNIpF2laDZROqbkxvIHKUWyswT3dDgE7j8nUBZZAI+IX/LyIYMvvWJJNkKTH+aiMQVkUaGqRHz8rBJKF9LK4FfsZU845QKc4R26yBavIDjkhkdfRqVUIiM6XbaQZKHpQVQYLLxv3AnleDGSjC0OmCjd5DYM3zHFNC4QRfeKvV9KjYojMsS/KgtRGZWoBSMGgoFgyH3TZIUtWX0A1qCLt80Oi4em9tGaDcStrDIftH3smyLGG3VGklUInZhbrxFsxsTsQ02+rzEM6wUck8e9J8hByI7+qhLuPkqgwxAoy2a3UoPiQXgQO1rGEa8c98yi0uJrFdgx/0OIR4aowvwiE8kFocXgCZkWPPIbAZPhDGP0uGgq5FMJWijBu3jBRHcDhK/XrEK3ZZ8a7mEgo6sGAIjlAO+7xdRFlDRUhXSF8h0bTzGtnwvcsMVRpXaqAsrDaN2jTCYjQqFwdgKVZnTMooL5iYp0DXlMRj+y2jlFnJnkWLyRJK41yFt8KMfCe178O0SzPyCFqxIEpiNJG6VBiJhfsGnA7h5Eau6S1Z2a3lD+qmj7etqw9K4sS+GKASIr0hxyJ3OS7aLeLJ8xanxZuy1TV/XBoXGeNSM44XvuJdsYZflVRFmaAdhAnmBoSSl2nvA+0KgsnU3vGZXSmT5IddHcinx8lFyf150zvXga8BXFOogdCHSJxfvkqeGz6LMnbMAqjtW1Qx5g4Hg3EvcF8xMR0ObbHob7ItwJ7H6M7kXKPYYoeWZyrUa0a1p89T3knAaTTVV6X9SqgGlSI+iIGg0dXDuhHvG3KkGg3ywfxijQJupOZSGzkMGDBmILoZWvBxtK/BChTgg0WLySGTA/aQSdMIEPhME0MZzm0U87ZCDtpcqzCZxIIjGk8EqLieQwEGMoacJBluK5yYQ80VukMVIAvJtRmnWMHkKLOBypJhvIROZigZZOvG7xjfjqatqAu936Wr8ZtSnbOZacp+yO1DhsMNfW6Hdutdk6BySvvZlGQMo1lWYARS0+UoLP6DwqYpYhJBb8lwNVpiO10wtHK14QrO2c9M3LHfSpZ1qZNJQBuAmLadpxCJpX0WpUEgCPNUS17oBy3CE2FmAgB0TqdSwFoZg8mJJQog3piJOL/8K6sepPtUdItcMegwYwf0bXIi2c30C/HN9NX2jMBsYLE7TZGZBoQQkLYihqfzHp8+Ybo2Ljnh2WFX0pMhlMgrwgAo+P6b9icUcZJ4c1TOJQASIQaNGjYHbCWniMYZtRZs8dPKZi7DjlA1hYmBwMODrpFg3nljEyaRKW2NxOAGG6+tWZ/2jk7Y+N1oTziifl2KcfNOsEHej9nV7+SX886XmO0GTjba3nt9VgWrY9N7FW85nvBIO8rRycTlGyxXjslD0g/6TKj2BNCOge1wiRu4WwKAHe7AkqCbzBIyJILa74b5kZSAJ0Br+DsfEh3YQnt0gOceSPSayICjo3hBcIg7rCe71Njk+olkXSyZzBmReQfRPIkZh5/mYuJRL/MVFzAIXGxCaWFxoMDF2i48sBlC60RMftyNo+TNCp06C5/kR1+YKTxogrvFEXN1IJXHLY12bHNOyYLpKOriALmHSOkQnHnXIpXKx9Z34dCCpxs5X0kt+Ftn5AhgkqkklKtpoWR7IU84cY1UgRmCOqchtIAmEpKQgJh8K+pM4/4DuJfAdoH8co5oUQlbJl87/0WBB7ORCp+ro6RcZDH3o9EXqPu+FbOmFx489ie4FmVeYPlt8vubXcV3gZ0Uvor4u87AY4foh8EjBFCyCSu6TQN5AdgUfIC6LjhcKMRUH+frgFRcrmAhm7UVoYuOuGKQCAJblEMMksywXGjB3nANjpXADCONvaFG7+f6BzE3qEv/xCPcViYaIH51NXtzCzG6R4R00VOR1+OukgAZMGWb1U6iyKzLRfbEY2pgMmIuJXCSX9TbCL4u8PYAJtBEswH2F3W7sCwq0Gy7b7bZhwAvDBAaqnGbKZuhExWhbWMIbF7qigRxHAmdzJcOyT30/1rPKHhlWJQet+L5XSYaWSWrmAq9TROmaAi8NyokC7/EKm+mISP5m+EQIvC4jqFGmAeGe9dEFl4Us86hNF/FAdBQUaxMd2V4ze2Inn0j0KMZ6EUjS1jCGAAXsE7sbkdrYZk9SatBNwaWXvyMj/Q7uU3LUWN/r+C6GjGJaKxRTIxoWxlj51lG5RJuwUMo4QB+ekIagTFUpZhS4n+8N0TmsicYm/FJVCDNBgv5qN6KQKAYpylPEywUvTEhnoADIX1HSoAvjltz62nfkGmKiWy9+R+QQcBuxBwpRAcUIpZB7c0/3Nzk1Rssc6F5viT0OF02PoQzI3MfY8pBsfjWmCbfFbID4Rh4u97O2iJ/xPqtNNUMWyQQ8ZFPdEUlQUVR+ef6KjjmqTWQusqSyMLMhVFye3mLu5ZkiiiK5HihbBUyRJZVFJFXD8wvNjBQiIwNmpHjjsowWxdEZLfRXFpo5K95YaOasILcjkevCkr5irtH3K+evKLLmr6gxDspE0VxRLYkoYOHyuyKRwoHnJfHl6A4ziYPdy12SuMcw93h0eTETml1kcPizZqAxUGXdr9rSuBLNEz8ovXgapT5GKyIXqYweFrbolBBlxTVSQtjdPFGVwAK7e2WiLZFovCkFF7WOCAjc5E6fQQwOODCiGNb0IaM9TMUi8c/aDN1TWHpRaqfMQHaaVqHLuQTuG/EBmGNPn56jKzdSqCGJHU4kh7wFtNmijBIrlFmLwscEwfOahkHD11gGDrgOxEHKMO3kbuUe8tGyR0+lnUeEOZGJcCuYj77ipCbIl4z0v0BC1HsGE0C/MLswE1pJhjOqNk+JFa86fW+LpZwYlS9cQCDOySRJttsUpxsj22xIHnp5HfxVXSLbBszkO7TKEz2UuS9ep4iBDIS/UcJfTsJR2ylJdYAUKIwvSo5I2SkgSNQSoELBOZmkK4QsKhi1IxVTI5d1KNyERYWwpSL9VGuhPYbsfnau2Nh7p60ni1tITQ1SxDRB1UEpPClpqqVZQi/eBPJEu/lqnSBFWNOrPive4L4/PK2FhnyoFlJTgpiOGiskq0ncnwihCkzfrqZYt4Ijt1XaMLxNUFMAOyl6BXOSJpPwq6Cb2uF0rmrvS+f3O9IB32sB0YXv5LeXy/Exmb/ayxvgGp3Mt6XzZCdl6RQDTW43+xpz6AZcuMeRvN4EblWhvy7PkoD5HQlLLXDlbwJgklBuSiF1UC9agVGxqN2KHav3aKeB9gEBVCkRc6Ao/1gLqmmlogIm7HZeYRGorhwVXlZTLbZstXYpybVihaRatgJTI+tFBXDoG9JzeGf1J6RunRe2OfrYtO5dUI505fjWE+FLVesOm0jpuxX0LKwv6pve75hDNh0/kwiwTxabIogCfIvSYrIV3TFD+NRUP09b+x97gUPx14Vu23l/ZDfRsFqokKEYAAXc/INOqjAj6DzhgKXiIpcX6CR8msgCuRKg4A6ImJdD22SKb4PwUhUkkA+V6gLQXPDtGA5/NVW1I4J3uiIJchFuu4TrAHUFWvPYMJKW1jx9EV3U1DhDuFIoD2+rHIrvbaoEEU+41QjuVvC74634bTG/rWh1OZpjrM4OvFc6KITfMy34zfFaIcxGnEyNuDsLbPtCC3JU60QfM7HmGrPGx5Ea9H0+a9jxH1i3hJMtZ6x8csL1HNJ81ni0BEbtNoc3xJa1nc8rBzCHuqXacWs1RLOa1YCywvxwWuW35GiDd6taBVJLyEeILz5FsAM3IaUDJk5QJj6BwSuhJmdzIq6fMjAznuZYApGBFjbKBxgpB9LPWhe/fxrvXe3lFSJd0nJ8PotDv5ie4cQbWyDt5SDuSntJ6JXydSUHfaTMeC87ifGUhd/CeATQfMhP9UzTD1i1G5D2UvzKSlMbcln9xUDlSPVYsyIjRjvUWM5WER/qAL3m1P6yVeqMADm1JFCnE/kEJap1rA7mstEWtaamllpWh5klwfJ5XA0oPpKzB0oS8Toljk+kJPIoZqNVcZ1QvkkJFruLROjRe5f2iVDs4AI4rqGi1oZolOh+Q6LQFSlqX0MkVIjQcKe5Xe8HVU4Y8ZAVugTOv6iFeI6vEKVdWCfMveiF5eDbB2j0AFkYPcrIloF4F9GcAC4gEpgJB7PItQh9PWL0JNIfHBG7ZrXLaThVoERn6rnFLrPn3OHV2HIBfh7lE4i5q7jFlSIP7kQ5ChV4XAbMGm/j4PE2ZAFZaU5vxKXBmYZZBwNui3FERFbFRu16YrxNDB17QEPmztAeEiZVD4mDKF16SDQBsOKPXmyCxqOXkymefsSmikffwJ9tsDxTpabKulVSB/yH3+3Aux14p+/j9fdZ2zjMnx02nxFdl4Rom69LEzGJtm19AEYQ8sehMaQnsBCJ7B+x63mScuQmaNYIkZm1lAcWxeCNt9TqQhVvwk2EyIm5ETvVaCxxUhpp2sR0k7uA4V4iLH/cVouGLx6qBfQAY/unEvdJMDekzU/Behanx1iNt24gF2x9EO3CakIJbSoaRjJ8EFnGbjRGlgbRm9sDyw23SsifgFG8E4WlUMyFsQSCgYRhPGwjgcINYvl+v8iVL/b7uc7Ak8MnAsqRMS6ZNPNEDnoyUJLXsprEM+qrKcYutaxENq2vgJAY3gZiFuoFJD7m5fBoY0RtpOWYxRFm0+LCEa+6Ixv5EbuDnBbwldAmPWoVTiOtv3UVJZCu3lwwB7QRWrKIJrgjxIOHhlP0jqhJ8ZU13iBC5abAxfhhaZjFHf8OTysJuKPdHJ0UqUL2KFADcevdjSlcyfwfJLhfAWtQc0zpyTU5sgeKI0LmEunlDqlqIq+ZRAQ1SYjaxmYAglAQoGcVPFGDvLmIDFrsNUju1hlxPJRVBvSE7pjb27dRxEwC24qnxGO/e7mNpvxrTG5hgRffwaLxeXRbj4A3zR9nWUfIFFHZQ2F5nSEsC+qL2frRyBKHziaG7YivUVBi4owjV7pu2LT8yLPzX/uEhGPhtRCH443j9hrTYIMsElP7+Mqo+/G0MNH/I9ZKveNpjXCvX9JegEmg7z6m7NrEYxHQNke6LPLzDPn43HiDC5uAcupMQMkrDsHRY3rRStGlPhPNpryRprx4YzaFG2VuNc5dbnMa88M98DC4jgyrRq7UXoafs3GclTXTvd8ukp4yTLYnjL8W7qFy+oc0so25D2NolRaCZ3GB8pDJP1qrRK8SL08wQ1Pt5SmuvKhVxpEAZg8Cbhrmbj/FvUVrlbRHIZogX1LzVQ96M4pXnZbshrgXOZdMDW5MtusR+XO5/ZiH+VrggNbC6MXHvdvQvL6DW7uhbWH3LoFFuBptLzEW2y6ZBWq8EvBEXgrEmM0i0SLhzaPGlODGpltEd9NM0KZprM5TksQrPHyRNJB4AwQk23kNncNEanO7O55GHm/qHD1FehRc7VJ0bNgTHruTTOiuSOr/YptpRydlXkFubiSeEy4YEu+qMA4VcOOQPRBD8eYxtLRUie9xckqIiVlIZ1K4fxdPfBkbqaC6yT7rj/XQWVA2EQdux8aJE6OtDSNsMMdgH85h+HE3FBNvTfqA31G5RMIPJwl4eOJwJ+f13A3fy+GKSSbRoSJO7JvFcwdVWuW90BtNdfC0TXbhXWEDsowLUxGPqO/kGAvj8uE8QQXiKC41jhZQDGmjGPAUiwFPdmOjx04zYo8+qCKWfCcwp9hcV04EY0UaxTidHCug7z3gRS8/fA6Tv1PA6T+N1i3G5uNb8jGRoCpghYa2V2ryn1TT3TwV5NMEYJwj6M9PWqjbnt3456IWBInfqL8vbFgoFKifBM9P98cM5G/Ac8xIPv76o1A/GVQV8vCLs7r5p9DRUlwcgNEhOojVQ/7cLquRy4cOCwhRi+gasQnStNW2SrVoinUS3O1qrAhrk4OqMPKF1NoilbbdSCWF+MXXCnTlMpIXqK3WBoVIRBRHS9pylDYl07rx4qdNI5gSCaQRu10xUUYw1DI98EnyuCfvF7U2YYnhVGPQsxQVg13kUEitVYqGsmgEcfAGQCtGTxYB04BibtoJxMOjVfh5LIrIAyxjyRUthbXJzl3OA06iZRRLJcCp+i8c79WqGsNWzMthaRZf3+FRx6zUKoGXaqu1VotHP4BmVZvbE0S8yPeAPzynPQhwQZisUn9tnK0dewzgoFk+mm4nWrK0X+lyGMhZsprAt/pDuFmP2ZGCqIHa6XgnNfXdQB3eNEDatHRggC3cPsgWXPzTf0IrtQjPkQ6k+VOwGTzVRq0D05RS+i4lO/PRQveRIZv7zJAAIgQunrfhTkK1DC7ioAMB0ZQNfY0A9gi6gV5B20foWRewqzbuGRRQOFGy2K8vAEQRrQtyLivCnAI8Wx4IjPihtX2BjhfbDMlvnSSjcxqSLWOvwroVYDet9OiPhpYMzA7g1Of6c0T0vsLdbjGdjGrnMV9Ffu7EzlUK8twDFUe1URahGNI9Uf8KqrFBqmRompY80i7Qgigtka0nZanGPT++xe5+y+OMJQcg2YhCyDI2FQKOCGvFAzDyQNm25QdihYHFzSVVnUsvgqk5xfi8kfGR/7JwqDL19wgeeNLQEZ6HmfkTMHUCEKtEYAF4BiH6waDtF+ldzbCXWjiZ6FilJpPqUgvdHXw1lR6WxaX82irrnRZaDchZq4T4f6JOtugk/DEdsWv7UX+oTQgGopbIUEY+ecAZUdfR+baL6R8cY3bJx8g4RKF90CIycYqrSbSUow8FioY0JEDg2jnmeCIQgU6NS7NMZKqasrLbU81L5jw123F9iCcS8+O+Lh5uGOBKic53JsQs0LfrUmwoTUcgIcefBkQVfRTd/nQ1zV9Pd/nrY+fgbwPoUYOAiiNrAG2oqhNVsXS1LsXKwj3MvFdVKaDQ71frAVDqAzlugByJdDIEkaEhp6xUU60EK2xVl0Hkz8N8jMIDxS+SrqUESwMpFt8jGC8+DUXs7astNaClGoVQFsKMtpjEC0WUJAPMqgeDgVLUROyZDzOyMdyoxtsQBbwmwiN4zmtwSyYo5wj0JEw3ArNIeQQBK5PUdMCWeGq3RpNma8xojZmtCSwTM+mkMz8DSQK/AMC1SYMGJR+aTUZiEN12bXr0r93lLeNBo4EkLx2HlYhtJ5CRj2+4x6HYw4h8AiYzbmdIxyrpaj38qWdEXtfHn/qIAiKAIf1GkPSEi7xxpKWwALm5nIqpjoAhgrwjkZ1M4WYFOzeXJfMUNoxrGugRTFmEWS90eoE3cIMyJnKKMHc+4S4+ThHDBpdJInwzEU9MQ1ubSnGhRF04Lq0EJoKTVhuXnsuyMkRN7ERiDhlyAknkXakmItzk7lGn3KXgAkZ6Gacm5UDXLN55aHDBWUq0xkNYTj9LExtwYsZdlqnmZhDCUHT2qLVydaAWpgm04jy1n6gm0zeSDBy6wocS08goLOiWYVW0jph/DG1siimHXWE51rJ83UzDjUfMzqV5U3g0cUIvIR+hxi+0aHdFrEdkAi3gnkQyeZHKEQe7oqOWkFnUqpGVUryoXpSc4/tIBBcxnrFeHkNxqw7KD2kJjaVkwk6uDAg2F+IJP0WyRCOVkFu8C81XuSmgyoPe6QpdelXXar4tTpkESTmRaGsbOS3Fj8QRTDEtljOHPzeIdjn/siFQp2etMa3QvnIQ0+j4MzFAVDvEtksM7wnvhLkn5jPy8CRg7UQiVbbmSoWCZ/Y2V6rcFPQFIKqLOWeLHMBxc2CmAWdj0f6UzL21i7qA7kYJymvTvm3EMmjD44cpM2cgFTrjAbHXiwsXeEEyAC2FQuXqcAfhmBoesoE0NS0YSBPwpXQqaULQj1FTObBJkDaimhD0dfn+p4tHl/MsTxzvVSGf89xhnJ4Ic3CNCPw4Y52D+N+Tji6YgDnDQdTw1yLqQRRDyjettvgOgZEcd7inMDA0iTIpe8nzzkhQSpmF1Zg8xDAfxz3u045LpL4as97fACdBuITXFzU8ogaP4vGqnh6YpiGFMBS3IWkY3ihMRbrRQG0QwqxY4tvrUWYKBU3UuVLcqasUD9UCZQSad0cny0WEDiRELwfoHoZGcRzA41URU2AuJJhgJwXwwiwBYeNrJRZoGE0syTsxQBvVunifrCZjTtQ0TCvANTqMQqK6oSDVrQO4h+3G0m8szDVFTCXTWohegamIBqnkx0nLj3cQ7Q5OjJHCDpkCKi01Fxe/BDKJVupgK3UIYVKAJfksYIzkMeBvg4CPmw1pAKJ0zu7RBQc0O/K6VqCvIv8VtETdgbVCDuAuJB6xkSwa2NNYNQHHIHrqEi7iMUalf+gkrJ5ayPAwWgy+XBdRvK4azyllmhoXBPwU9Fk48fOdCVMYkJBmi1hisU5sSDKNbbc497c2F4rjThLN8WhmNCVjVl+7KiKHSDZPmMn9GB3kaCVogJ1rDgEnSu1OpHF2QUIAJ+g4E5LQuz1E56TO1qC3RBdFGCHZh9GR3yk2opBWACzEXaL1w3Ujsm2SOKc1AWiZnehYEgnm5o62IbnCYxSpMeoR4JkipNdatLXjAtA6udEYVj0K9LHiLtUUEeJp0lPwQyQ0wQjrAL9OJm9k/o0QETmaQvEtO8VYBnjwJeYhsfvCWJOOu4DyVGjQAxhvh/mM92Jyjzq8xRSzISNU04WhmoIIGthPO9yWZtGuGRcxC5nmeXR38VCZoSCblShooca8AlY5hgWS03BvLdkru43MGDw2VcVSGgBuPwlTO8Vp1y3B4/xCmCe2LqiaPJ5PBQaJR1PWjQdu6T4q2zj7thUYBx9ZUkhbo3NhZTkxs6DFws1Tx6y3hkepDA1hXFz5STPCQGMje0dYIbZmhRohoW7LZlMoxGkkRhJR4FXsZUUY2e8OlXSzN/mtwTKvLauUdlq5T3Ea9I42ftB8HSs8FigG0wxJp41YEYbCI/qtIODZd8gZO4ZCEeD10hIRPCnTE3Ej7FJC2I4kvXFX2Oy2QqVAwbSPZioRNcpKDKTLwZMB8+3DiNjh/O9ih9MUO5xoJ6c0VSCEB+w5PNOH3XD8cBgH4DrI39IZtVlgjaxHdMDzkF3WnMMRw3+sJcnHcLJHxKLxLxazknHjouhawMMhSifEeaMxyIb7n5SIxEhYx8k0z+cjxsGz1gXiMLiahz3EgyYE/MFyDjUGZjlEcQhThHm5vxG0HxcqAWYSHyoJxBJauAEt4jBTDe2SyZx/YJhFAmB5Is04WXwC6KIXhzwjNkSGZ84zMMGEGRJPXnx8H8aoIPxearozIcVHPSoR48sT1QRErwRM/yjCVbg44qIDh+I5xrpB6IA3xGkXOBf+WA/nE+Vq5ECiA0qszXR14IK4XOgoMNJW2qJFrXi3SA4ouknTgu5SGI68nodfRaVXiMpwQmkiyXCukOYXiEMVUwJ9ngw4IJXkAavlZhxr2gyMYSvFfOriUe9yWL8/CFbgRMkX6CkK+m7rLmYtUvcSQ6aagi3VwpZqq7VDQfKbtpzSekIYRYhm+2jRkjsOzDxmMql92beBO6WGQoHaIZB764aQvXDdMwEIf21ypzRj9uIwFYopGFhCxeKB2cdEBZWhiZmSQAluISQHsdFmMjyM2uWptewUkIJp30VSkVj3bJcjxlSszHPqihym84o4kY7vcCqGhY7y9OVhhnyXruQhV3RyryjVmce1Gr1qbjxIA8J8J85IQm4UC1wnRrB3N24LHZ+L2+zkQo2xO/y99vLhLagcO/GoMzc6p6CDBH3fhgldUE+geL328hGqqJDfigfrqi54msrTdDI6VAa9CLkaSAG8Is2u6uYZdN168II3R0SCutEVgpz7uN1BDz4v83CeoMJzEGPlqC1wDJwSOfwSLLF25MAoc/VfwTQHKIZxLRnWK4Yi4SZCOjkewg0+ThLRjQppoiTa8E66uBMdAN6O6gWOUrwdqIVFtSOCK/XDSZKVM4dYCmcbFEOqROWgMOCAO/R2VKkwQ2peDg2ZB1Va3b8sB8QL5zPhamzNqsfNlDrrE7HZIOCQ5NTh5g7zGRlXKALbqgABqUIFiEa8nn+klnkZDNT5F/2mTmmIPN1QwUgNkYkS434SKFiN5HlqqC4swVL0Yk4MovWqjhofxA1FJJeMS1x28rYwEiQYaRNVHp0pYsaQroKw6ibv+V4cmDFWl2Lc0ShR40tJU0pBu6qxGZyCJwqkiCRFunyjOLJF5vim4hcdaEqgUH6K0qIOIM2DSdenTiDwQYdsYh8Cc3XR2lgfSIWBlaqJpVZzHW5dUsgXppGPMeK8QdkyD9gpkWVnxOeuTSQaQdFnc49I4SSZwT1XVfqBlclTBOG6o6tkXKZ8G9NmJBiQcozUKKSO8/0JxHniyy7KGm3mCzIPrjAkphgEUoxQWng0uzVxMlKmLe4cHiNsZvtWybcCCIjvYzEKV454osrmt/AJ0A7ui0kHAokqkm+neK1NBETrZcXQjED4iuUeKLTxYmTR564zNooAoM1k8qqmHMhGnDg/JCXSV4z0NMLlxMzugEYQanohFkxIW89dPWNN9/OQsfGGPuNiFwYD/MwKw3h2CVxowk8mVlW63UrHTVdpIeEUFqPbxRhiUXlXRMRtpaiApzJGQEou27FIFl08wMHOt617cWMYeTAA85eEJxNCqD5vva57hSRJhVc4tIZyDJCvDfrArjZj2ShyzkO+S6/w+CqDTMk8b4Wo4XveeMUI1XJQcNaWmsFZVPk57m5qOc5EdlfalDiSZTA1rUhaIY78UPJFDA6XXjk5tWMmNpTXXFzHjSGXzUhsODbB48MDtKELfMxHvoDQchz5KVE2FkWNI+aQwNO30J5zCUgxwkfESCuJiJ9o2rGAQPfDqEtyREMpgXdFjafYhE485iXBus0qw6wmkOcKEhDO+T18V9PLLWSmvyTlW0zgQX0xfAuAAv29GCpKolECOliIZOj0C6JOgsWxJWpbPiYH6seKflHPvRLm+ffwgAScKBsPG5W4G7dEh2315BsKipgFfSrNQ8Cdi6ZZ1U0H/JDHHI4cjfFTc2iZYX6geGFlLaRUMjBFcQbg41UZN5js6LGE7I9AHxcNfDEU/MYV4E+16eSePNVnbAFwX2lVeF1P5dlTzASyIBL0wRyTwFd4pKyCW5duF9CIGTOK+EWJuNhRMhMuDsqyxaDdxpKBm8Sv+Bu9RuYDOuzXhsrWYWxLpFgsN64DduH+8YPVg9J8qA03UmadC+Px5pxonAgHV2KaQlMBDIH+afiLXNJUe0kwWGpk7wBBX6Sv1FvkkKKDXeI90HFgMB7fkyLTjIR8qYXItbHNeMizrWJSltQOStFMehHvfB2UCzPEHTBCcgOei8U84sQnDjXm36BwuyfmWQ82dltpts19wEJ62liTaprhxZgsn8fu4dmteFR7KbSMCY8YTzAhhvMBERMgPb4VgnpJXn50zPEqfIFnIyEQwLPT9Mwv6S6+MyhmhwdYc8Z8WDwBCc54KNHx6EaGUFUkepCioksl91NRaX8suUItmGKwJAmZijRRL8LIRbgjbWwHfdlMV2bTr+Fp+eiMJlQRHHR8HHBYj8jh4SF3bxob1ia4c7As5VkuvRRW7YmkRMWknTwrKsooKhqTm6MeDWoU5/CqS9jnXPQmOV2CiBHiKEIZJbERPt8Oy3y/TPNtM+fbkt9Tdbg34NH2RsJ0Zp5YrYvjjnFi9RZGVDFooHpHIxc4HobpJL8bOlc5E/118UATIPXwNBVTAtMpwS7K1OijWI2OOfygXJitIhfFhuJUIwLpFKSM8SVQiS91AbFF+EIa+t+78LQxU7f+Q5JxU0tXMHo1DXNY6coYgvxkmLPpY2i+YA2RUMjZkSROmeGeejeRHO8AukDpm1woGtloG5iTJBhWTkDSi+ReXGwqkvkJLtP5OW0FiK6076kznjyLZ42ic6pJlMtFb0rG/cXt68l3jifZst0oMkjxw3foDapM3lPrgxbcNg4yoN1pkabX/VKiKxWG7rakqLx8zYJopvLj0Q3d2a4HN7op8hGND3zjl/qWIadSJj8Qe8gdn5zHqna6Kdk3tymAdpVLO8Tcl1BfCy1hHgjcSMZWMecHucTjjwfUsgs73TyFKU/fDX3AcM9AbexHhgwiaIDM8xhYWVf1oPsDdTS1hgdaepQHWjptx6ehaw2RUQbCnkQafnrQn86Tckmgn1gdx2205ZCjpiNU02j3NM3YE0gyInzFBl0tNS7PX09Fj3KARn2kKsUoojbAEeOFSgd6+/2ARQHoS0P42wj+XkVI0Bj+NkFnDeSk6aqKPxl0lrgwzvubqhlqeom/GQ21dpSnWXO+zdbC8gS4Yaqa7G9JElIL1ctFKaG/YB+LGuXlqC1wIxIm4ZNYLGtkOG9geZu8nEArqEBuSkc8xOwyQoF06AVTmxguIa1DgYwg4Vy62jrkbx3xPXRiVnLhqpGKZnzam2RqQ8wOHlxMGzdqBgAfnjUGeBrPQkGhTBG+pUFpS6oKL1VaXqpr3OJBMGk1spRY3KNaq82DAI1UEN0AIC1pClvCsGAKW/ApJCRK4EhkONk0V1vxzSYWGTymoUXDHn00pDYr9WeQgZEf+ZaG3hx8kEb2d+hoSSCd6wuY+7wOdNvD318daK22pv04t9FnryUVO+40xV8J1fxkR4movM2hGyWEM6upfyHhOs1VY5jHqyjhY31uZEDgNSC/nOYlgFxYKowD/laIm8n+FrjdhknbSfJhaj3oiLNXmpqWE2gpEKgVR5A0/upGN9+AS8dZMZLFIEgMHz0S8AEBWxICcnCpTdFaQJiRThCz5JmRAnX5kXTOm8k7hbZiBIjqqmm9xeZIWj+eESAF6Cy1zo2TTG1KjDeHdv2u0Hx0g6lRMBdbfjxduqG5N8akDv7GACr4uQoQHwqbqAEipg2prKEawLIALB8oa2REkqSg8TSFAnLQWmikx7HkPyf/ZDvtD6BWHWBCEaZtQK5Lo8aAJo+GSP5a8KM3tiBppYSwRIqRMhL14AmLGvNDfYS5KoPO8Ea/ckD6JCKWuCJbUr4jPkfkY9j66UBGjXxDGS9xLx2eb8jp5ss4TV/3ynT0oa2jOvMCTrVOVNohDNqypB1qXkJIyWnnut0P5wC+tlYzStR0TNksSoy5NVwOcB6KaCLEJmrDniJe5wIylVrIiYBSkPGuJTGMgJd2OJXIBmKqWktkFSKYwXgpKiqVRxYTc2pM0KMNE1hfhPCNifRaKVgdclcilsEJp4VfmKSGs43IJjd+johrKhFXzkGIxBpsBIdnrm0xPA9RJo+RpdRrpAFArKkFLUq0AgXaSeIY8COY1S9C9JEetUL4IDmX/YBqBKWm6H0KTbciNGlB2xuNrabC1nRMQy06mAIIJTENrIKkI01QQYN+2FEVRL6GdISg5TWgBQgCkPACPFvS8kvnMOMrUOJ6N8IN/Q4QcPgrXeZyglaDokYoQ6XSLxLtNkizWwPa4P8ZQaBd4kwDxXq0SGOdVqqVtgMAKY1CKzybohW5r/iT1KZYoylBHtegBYBR0n+Gu1SW0YHW2HJRDDmfjnlQjHMbzVNPXJZDeC2ZOiWRpVLhoiHtl7l4Yho6kpxn5jFiITHylOOuwnkR5pTAFDZOXLr8nAucfaT54rQuOtyLUjpaQoqju8OwOywK08TxfuZBpi5uiJJ4tKPhHL+aZ33BRtD2tI4yUInMbDxe5nuZUk45C2uASeZgQoslP89al3PWY0wBWepshBGqnZ+ga4ZRRiySov9ifVnONJZFyLrChWMCZwwHpzgxAe1zkdBSZzQ4earMSBfMDMfATgG5uUPNP37cAB4XEtVYA3gxHHhukVOT58+k1jHUymYEcJg6W4iPmwvr+BFE+3WU1ovPi5HCTERux2LO2t10OaeD5C687AQFGYTIDPlw9YIiPFOT+T7hCuusV4ow56P+BePnVyq83opZC42TprsWdpDX4K2O6YZn88RA8tP8CXVOHz9BP/zSpy/ZJ+Fm0ApegjH9r0QuL86ESzeq6O3l2eIxfby9XBR9uw+7iO6C7eUf+KVe2F6uwEsSOi7iFeY0qKKLAAVK4/Evx/k9ZhmDu3O8mribXbSQv3TBUsnOg6wVfaFRWkQXRpPi3bm8VNRVcW+liFvHqMf6VAFFPX6CMQoESvyEtABuC2BYlqz3Qpuakou4z2OpEMprceTt5SNixEp7eXdk8DRVvDnUgzryDGlX/g/Q7TTG/vPJK8c3Aw4dNCg9CWcHft2902CWlSkB2xTogzKBjvTSpQmqbaIuTQrYuaMuBymPXEDVkGfBFocgGgBmlL0JkH66an9gQnv+OZ7jR8adCcq/5HHTsU9k4lAmYnAVxoAFKCGcjWBg83hwrUJ/d1B/nX35Mc/GgZuKagOKAP8EUNBUcidOEBcTyLgJvfdM0X3wEMak26forgkI4Yn4HRyiPEW3TQjYJmI7eC9N0eUa95J5n3MFABCl+qdRBxxR41bMHRkctzj/Bu2lxsi5lwOarHM57tnQFx1pMYHCOKfRiTOEAVTiq36CzyG8RjcdnhtSdeUHXBN4b1TXRNERPHua8jSj1OJy8+PGPDwrlUsluxpa8V1wh8sQunpI4Br0h2YA5gO/to1mg47ERtevmP+vwBstYVUzFgpY04mIUycAcJAfoF2B704B5UYrNkApmeopmK+GtpZ5bYrkgb+9A/Y0Opsez9TEHTa/nfwloN1U8mdB4h8AVtDDS+uOSIzgRTfWRUsXnz8ADgCBH9qdDDhB3xQeLPhxhTux29GT1o5HrpKhKlLPRaW4r0n9xu1z3Ef3xGIQAa6gcOGNtDWVhERk/AQ+vRzgTu6Pws8TLsJgUL0BJfuqrq523sjT8E2haSj6W8vRfTQBgFXkVV3RgJ7gBOQjRwFCFk9PYArs+Xr8FIT6RNU+kQhQPsUapeTgjEzEHW83EeZcjmLipKyoCbJz3iAO6aWDwHBvpw7yoim58G+DHmn5pLu5jJkzpsih2vqRkAIzhduM3HBO13a/Qnl7zPnFY7sxnVs9HAr6ptC3e6RhADg/rUmCr/AMRUQhXBP5yepAJ9wmnVCdE/hk/RO5sAv0ZYi+8L0I+toRPe0R9I26l8z7aPQl9wQMJUD2FDXw3n7Kd4foYKcZpGGiLc6BhgKOsy68IGCI1EskZ9lMwghtIQBdiMtuflCfB7ruisJll4HLUbTIE0MvROOoicsuCy6D8BmogfMcl5mJyw6Oy5gmM0K0AQ96835YiZRCa1P39fbWJHQWcmMhQhREohp0kVNNnj5UMUmoQpNoMg8uVQgSRsnJ8NIgvrDieC+Jn+JpAn15Lw8bvUZWxHg3LR2ryX4pwSTvgRJp2CIidefNBvGaZ9D/n/KSxyIv/au0BIvY5re5RTwhAuYjDBikHISqLTfgnoBR+bQTpbdpL6/D182BX8AWApyZ4n0V3aMvDhLNvjzHTl+vJE67tDags5aMd8A2wStIQgR2GIOok8gmwtLJCcjOzc52mqEcvFGIULv4LqQhbwKOFfbw2lG+5m0SWAK0XQnzMYGfk8lyyYzGV28OJnp14ATizt7fnBraaw7SOkSHGCLSEuVGL74uvq6gL7bkcVIAKZAtYONGizazEj/qlA+kB5J8WN88a2UPUlrwuHVHX9r7dqqOXHP6A7YcmhegwbzRvhSbzzx0LKpNCNzUCPYRlxwVIhvP5aV0/LpCLiKFPb12II5EcZ2UpMZD9n54Lru59CjmaKIhXMOCFoMBEYE36DclfaKehehWqPAf+Eg/Lx2kgaQK85tybDAhiXAEWkLXXDvKkM/hDS0lJDN0Z8qk/4QiKjNQhA6TdQFQZRM10HfaeHkfX5vibON+1BvVUAgEnuK+mFAfVIvqYCgIvPsruFj9Q4Q4LMQn/z+mPai4pS60BjVKYwA8j1YXbP9VXVBNVQEzQigtmUdHSVEVy5PxlQ8cCvCUf9hmfNiO+xEGxcS5d6t2kzoSm3Lk/FNPLJSTGT3B4wZ5TyQuUJkzjEdBWWZWZbQ7hkvCbmBNtHbD+Sp8pgffv+aYg8ZRMUJkvv+LJvFbQZWAkJMbAHdz5HyFj++Ks4LAMPiAHcrtotxullNMeE4AZCg70WoH1xZkQ42zgNZOy4pfU+Zs4naKoNucH0ZePxR5fYfl9R3Rr+NVDiIEo4bwdBcbqXn8PCgFRBKR80zRqylJnINchJG/RikcAdajLn/fg4fUUzdMlRJUH1dE4ZMJfj3qomjJVQwFRQ50/EFRJYarK1xYcfQgwu64spQi8aT3yTweH60OcOeL3BH14+IVblBzQcWsyvjZqiSo2Ph5DXSMM5lcjE6k4+kwhsxG7xKMDQxgXomPc5sYpw3Huc0YZ4zu05PVGMyk7eiRliPe6c4T2MS0l1P5R3wm8UK/O2o6laCRLApwV1vhGMfLMF0VeqyoTsHmcOL06RP4lNoFAZItaqJdzJ+ddHmLpqgYZJRr/3aMgwDtgOuJgPumnqjw83xoGWCSYa4ZKoburkS0RuQ/DUj4sJtaiP2/aiE4XIsWwiJaCDO0EHu0FqK4+efTKZ81QjAyZShYRnQlhk4uXAnm/Sd6QrrwNrEwbOhyLBuDwiF6FJ5kD3NbotKicKVFoRT1fB8yYBPiu514FOghPGMC1cINfFJKAuT9ywjVuLuK9XMe8VXKPfkPFN7NKbzLQuGx+5xekrmgg4XG9OY0RtcpEQM5c/ROg0Xb8D8wBrdBjl08Mao8F6t2oNw/cFfE7zBvPDp4tufF/8hmDU4KlRvlEG9XdCfnhTwfz40cKDaUmyiTl4HM1PHcgIOzRoeJzg6DHOmkl/0jOuOM20G15egMH7Sgs91EZ7ubc2VPNE3izNgFwpVAZ4eJzo4rozOp0BF0tv8jOtst6Oy4DJ1tHI9t6PDO170Fo+3/hNFcsKiB0TY8X0toSGJoOFAUGB1XQmp7BKkNZdzRg3RiK1Lbr4zUXIKJ/qJHfBiXkbCNCZMSX2OIHKl8JXj4Ona5+aFGCkqudv4KldrFCOADRKr5/Hj4bLncEb1NqaG3kS5p5+qlKRlZ0d0ekT5M4xvvgnKZoiNTTkGDRxC2pmPK8SguUZNHoIcO2f+cFvbgJvbgRvbguow9uDl7cP0Te3BFbFtX4BDiGELyInNxXdpQiV01VWJKXMq1bfEEb0VtRj6KRoJ6vuhs/8/xEMPnHOeV8UXHOLpIxqKzmYvO9l8XHfqXWhadHFl0srHobJctOsZ5CLuch9j51i0uNJkvNMYXmhPaMxYaIVGqyoyxCAmFnA+vvMpkklBlc53ZuJYF60yOrDPZWGcOOpFEJDEiRLF80CO+S0eNCAM0XzG8N3yRMb5cmFhkLo7hJEXFGvhMRst/wmcXJX8jfI4xrPgmNscSNsciNjPEZl6ZsNmF+eVSuT1VYLPLwGYXYTOzYrPLgs2umtjMorGZXQmbGV/vNpNFmkK4BZv/p+GcYzU3m6sOjsxw8c+GcyVCwlTFEI8Mw7k9Yji3mVYn2utX3JZTnlWFb8ntpS25Kq/kNI6aRKkA/VcYzzEVkAFnAnzx0Xnk3OF9Ao/tpaANoHZSRH2y9fbSmR45fmZVGaQe/EAZsbYlLt/LNfhqwEHyvYRiuXwF+d6yoUPiGFSP3kJADJFQvjdTKHsw2IBbNeijMsj3DkPwcpjyvYRCu2wI7Qgo807nHqbkhQAzG3BEVUVVAFaSw5Tv7UK+h4mXjE5Ey/cyuT72pB1X7kj7L/K9QmEIgPJORHkJUZ6/Q5sNDgx5S+Uf8fGThGhwPt50KkEjGQskUmEMgRDLBInEpKLo88LXnswlIi5YcTUOcEEwDcQKwnU82lSVyIIkspJOMFa2rCPxsthb6KxInRxQL1M2UaMzlE2zcVUy0aYnJvg3zacWo2p8lD4a+cJl+ij/wo6aXzCGFI+aMxBFjq4WBFX+FUGV/4Cg8pURlAPdQFCFI6gSZS1X/gVPlSjkU/6fwVNm9OUKeKr8RzyVo/BUseKpZMFT5Z/wVBF4yi7DU/eVMDAKSSQLuhJqCiy+0ovc2sMnmeHsyhayzKIlDKDsqsy5MSUIkk2iLGKIKO0FTbTEWZ6E8yVxrijR7MWjgCHzjwoBg6GAQcJDRMCQr6SkOjDwLiJgOEjAkFFJdUxErwgQMJAaWwQMJH9cssBYAQHFaD3VKtc7+AAVrqlKXNwAdDTFDQmlbBsHoBibJLCYkcQhk8Qhc4lD5sqqgyQOh6muMpQ4ZJQ40JIrUT1MV8MlDrKU0CkECvWg5jc94tMk5eDKYPypTXTIFNMlLr4T9F3CVMzNruhNqxeqUpqww7rdNzOeElxjui8/XuBENcEBqt8kTlz2TcmiPYGeUZsYeiGdu4zv+Q7w45UDPIYOD4Qj/3ppKDbE81mvQecY6V+rPMer2Bg0VRwrOQrFEXHcD0LmYrnUkrHOmN4chsM3G7mLDx1UxhkybvPxmlJnhiCfzmvKvKZ8pZpyZ4ao+DCvqfCaypVqKp2Zwn3/FR4tYOOO+qTgyvgQn4CWKzZpQXSfgF7MwrCH2210MR5nw8dRzt5UJnWfrlwdZG4/oIOlaX9PEmILCBXk8WTWxxhNtG+a95RZwhe5R+0Qz3s27lXeqsrTwg5B0S6ex9IqfiEBuCZ0j+pUlCcar2IzqlAcK6OsxlTFZlaRjSqtGbuO0UGC/NMybmfihE3wSly9U3S1t9c4rQqdvuMUJsmKW3wg4OjM07IDIuIs2cgegDOr8Pmy4Xw5hQe3U6WwYzv+yDyuAkROFyj+euqUiVxlJl8fF9/MxiJXpMiFRZ4rvoWBl2K3O/ot8iSU+JTCBN/I0wcQXmI3sHd2ZAzGcBAcCkdKgsq/d92XTyO/Utd92AnfFbse/VZU161vRXc94bKuywKvrTOh8JVnMxKr/3PXU/Npqq7U9VTshOuKXY9+K6rr1reiu554WdcxRw7HLp+BioJ04GCY1J5RxuumzN6B2Tmieq9jXl4vvjOLj16DvKnI2mCsAzM9DPkS4VUia4Ox9oyJRSGWCK/yP9aGQnIkhzrvMpBH91+yrBRK041IHgAAkUEU7XBGxK2u9DYKZf7DlwkvRqwzKjrNigpl0jWex9BzFCVykXKhwRBgXS1N0GfMnO3KC0hcVZRxc6qAymV6m08Xva1wnkQ/KDxOFcWynm9WrGNWTOU/yfzHx39AtYOJNV7LM69GmVfDjaYI5nrqxIAdhQGVErS/2hWPPPNNx/1btN5LFOrq6KAIviqufOaVy7xS+fGtQ3BcDThpZO4DNkWaLmGWIOBemwJSV3XuCyjIVDtBZgHhpLxa6S00O7gpQni8MBHh2C21ZbcBf/n/0IxsqOM7BuMjvsrICktK492G0F1d/Tc/YRCaycpBr/2zSm/iPPBfCFVv479uMb9f8n53vQwNz31TmlxR2VsLhrpdt3jUOxkz14ThcmC3uXEDN3+MTx8ed0pJ/OwQPaU/2zEM3mho5tJWb2zf8BY0dJe0KC3P8RPW2zH/rqd/bMay4PLGlvPTm3RWyoOWhK6lIZVFxlGlqWylJVFUgKnmf//3+2k09H/UT3RVW20Gqr/1UxlNlDkraIIGSASxx8FuznuT2zV+fklZsIS2skStE1BrE51FN35WOEBnXyPcgvCm8UYmBbrbQ1hgD5ZSayUlJWYDQTrwZhUut67stjS6cy+VJKXAAkGcYNkCRKUkYMmhZIO2S3DXAv/rVpyyq05Q+rNLqNsD/TfXytt8O8LiJoLZcwgzqEPYQlfdDnWc+8GJP9duCnXb9sbbm5494+8CtV+99emiftOXfhAMEYylUEkw6N7ut8UWygWJhTYjnHCdLTdgNyNCHSQj6alj8IgEDLPqg3sco/JUoFwxJOyAkL2PTjShUxB4jLsb1xK5bbtUdy6mt0M7khNTXXkNeuYEXQUPHFGVXGzjOLVBge7lMhmK0Nn78qOI8Kh2TLSPe+EJRoJrMtms50eb8/PU1QS9sJc4X3i9P54fdKvGc694Hz9emtzR4zCrI+i3PCIBt7s9btVr6IaeGqGJdMw6pkHUK4wx02ep03QGXw51ADcnR+VQOlGZcvnEIuQobh5GnUAUn05hVPL5uzlA/OhADBlTdxPTkC77MgYjR4MBDeVqHDox8oPgxCEOIjdacxEDQHe+YBCTQuF3ZK4VOzCzHw7eKQ7R4WzGaYYT0qA8qjtHdeYa6WegHRowz8hJgzVyKXn4OT0eHgUTNVQ8Fb5wkj9Fb63G5Ppr6W3wpzYdeoFhVAqMvyCHTmiDT2I0ah3+GJ/WFZfjMfrGjj/pAN2RmCI5FoFFUS/YmwCFunD0wMCrJDpxB75e3zxbzMN33j1cjfVgD71quioQzsm/hKCk2kbm8vFdQoH4GnFW8S/xLKk8zipO5J9YHzDwdPxmBFXAV+M1X43X8JQDMpgSueKzFw+v/b/xZRTQ4oi38q/6fUa2NIElXgt6YLb1XNSz6/PFK+eL81P+R1ejg9EIvuRmxQMN/0uvo1sgiwpPPoJONVNzjL5zOPjURN9pchgz+lWuhZ4Wl2r5P32jQeQbDdzQSIP1JfzEM6GkYKxwQCV8smIsWjPIFAx0p/Zk+KmdL3ZTHWqtyX4/PG6QQ42riV6pxssYXVMbKrlVP0a9IEbqMrzjM1nCCDJu+ckChsHU3U1jF8drDEf26jzVKDzoQf2bzvHdK3BZEFKeb8dJthh/HPe/QHewoiIXHjfkxRj5OFJoMTV5Lj9XJg7JJsh7SZZ3+cTFdTdedtDLoldJOD25Ih+Bebh4fYxrNA8zCvCwdMQDCncMxNFuDW/dae2XU5UjTeOZSLLZNObE95JlSUEjE9zWi5MlJrvxkYRoWmOinMQJVHkC2f4aUGJ9gDu6fEVYrg8mnabAQWhhSfDNcaqEsMwsYMKoAewN8wrATy7ZlHk6RyAycVSYksNldJCakdqk8TS6fGKwkpgcVahRhs5kKEiqYyL8iSzKOKSJcQA7GJVXuFzTZktdfl4KnjfHG3Twtwo4tzPPcXVEJoB6wiskUqIpD6p6Hs68YjjOmE3ge3TaayoSeeq3SF9/eT1MGKaoHh7d66UMT5yXgBiQRIxDZOF15UQz004K+7/K/rz/D7G/5Cuyv6T/wftEah+PGkcpI+L8Hn6AJ+KJngpsrgY5Gq+P6C7oyH8joHKENMmXEVB5/f8Z+eRnZhiE5QpvRX81kR+FaaIMGVjdXD6KyuUWw0crTovkqYxMdmvCzdoUHYHXiY62LMSpsUCDrzYP2QKNJEj4nkxxfRzXMS0WIRk/BzcKloSXvHHEDMxNxJcYf4ZqKuHCeMSFeOt3KeOHWC4iXardOA4FR4MrRZUD3lxrhkPMbijrhhlY1te9Zpzzl6DKEfzBc/huJsMwEUfg/73xBHLKAGeecRiUcvgRUhzJErCrmPuKQOSlxIHuGmFnqi3OJskyc1gCYxvyA6lsHLgJomEaSAAXCaZcFfNEp7L5zKmiipRuEa3xGBHZiOQSnmk3Xm0ExJLiwBP8ZNJLMGfJIXgztkBCG9EjWpOBq2jUPH9sY8RXaLKRIZPD/DRW43mrTvjEVWojfiMWbSOST6bj1Es3iqmR+eAknuLV7DMF8ppDJaEw0olG9GEjPha+2sj4qsCIePoQx7EbeaCy+M50RMIEtJI4vLIFzOTe+Q/qggHhHHzNGVUK0HZEoM3xS65RTmStEMfno+5zKja1Bk33cBbDzz6kFWFMwCg+AfgSpWsPEqzFhUtcmO0O4e0WGO1Kqm8VvOvH0yg8tv8/GCQGaAclLglItH8ljnTzIGPnglahYOgeZOhiUaEVSRbJonxkthJfH29cTK3ZDXyDWJDNELEp745scmiEl8zhxVs1X+WUIxLebBmBiztUXhHWDSMcvqForWGEDJqtOY3hUf45z+Vwbvi/4dzQgLMD4ezQ7fycQ4IusW4/ZWLy8TM+GmL+aAlL10o4BIkPSRSuspTCtQvHt8443wtkOecE9/OxDgltpYWK9VjsNiCPRdJ+cQecTQEFbXkBm2HNs+t/HtpUZOMeUNXV2gT9r62NelDQq12/+OYCKkKJpCu7jfqMyJ2FxqRwMMC6tR12f92hb+/bFAw4eHcBQUsiT6G7mIsNfe0sb2qWN6+/4pvX05uF8CZtr1z28ZjySBMVV/x4Bf+4TE1Y38yyvHnFj1fwj0/3c/93AMPGhb8YYLDrZX99zsGF4NlVZOvhlWv2sE1hwReJ1MOdy5e9sCTuRI0emk/xO4oVPPRmluXN66/4Ju/hw3xsdpixH7Af0pUgVccCqaorQqqK98NWE1J1LJCquiKkqng/CghS0I8/t/4wD0BD6IsWzFk7Ph7TZvAPpi244w1GtsGOW6E9E5FCQVBQHObchwKukgDjSSGSpwRiAGu7XoP25/gJuXpCL57hS3XUkNocL/FQNy61EdpQ2kqMh4KaQ0TTrARTfnWbNF5pNb9O6XUhKI4tUVlJifFRmY6ws3zxakwNGUuCJKaZ4AkQ+cvYGja/ubd61apZD3UKYV7/qNbc1AFWorpK+MomHEIDupOfrIoGcT5YuEZo8og9rgV0reZ/nLPIHgt/1m1ms8MBVmPsrMbYcbdiPU6YT7jdOUpM+Tv0399Gz9ma73ZSVN6mSVeH4ql7/IR6JIeYlNiGDyg7eyEdDoMiCEX4UGoN65tu/hJFEyRP0U8+kEP5lHXJ9zlJ0jYiqDxitWvhQA4yQRmhxLWKQKbacrnvJ8HQKCNaKVtzPa5CE7RlayEUUpVuBZ9+cnfnL368PtTt1NPN5//0490f8M2Cbg///cYd39f7qEuo26dDN9cJSs3Q6Pz8BV9CQsIMDfQpiu0OkQOnzEN60ETem1vyw0G+ZUA5IqWImRs3uUIlIVUqUe1GXS0ULHFfAOk1QrutKTKIbkfvwPy1dU01bpxEDkDAPfpnN68S2ycmiH2f8Tg7jnlyBPMQ78Rjgzeoku8wfVyZYOxISyJ9kMtsx/oQZukLfLwKnsuXVV5FzV9e+zKXxH2ygrxLsm42BWRjsIrZZ8veQSl6sOj10T8md30wnm8zVle/TEARN+FfaGvJeE3NggnpNvqr5Jnvj60CiEfsYzRJhBQY5gD/dXulFkv87OSFD0Ldfhg1ouGS0AM48/3qfP5V/2bP4GXSe+mjH95DGzejqMFyLajajP+6qUNDXW94eh+87qubHvh4kB83e+JzD24L7MvHy/f3th9403Pr8DLmyJd7pj3whfZvm010FgqO6FtiPBEwAPr5jnDLDPo7r0LnGNxvce+wS7YC4d3yiYkoRX8e2qqp0srIkcEBWTX/66Y5n4jtGB4ahnXw+JN3tW8Wwk6dzuhy/YphZTjSH9T+RTsHH8Knv2zd8FfWgc/xad+3lr7KFn2JTztO/v2DDXcNCwdVa7P1Uq69Y8CCucAE0r/un7vl5wVYtcG1w44NaVyOly+cWP3FvcPexMt2404trerzHV42/P5M6oguG6PhUmLdgZNUKVQKEpa00kgJpp9+9ynOmuWoHty/Kv/M2crXYGDL+vR6rLJnXdw9a/FarzOlGffgZbIy/g7/vgfxclTGaX+d5rPxckLd+Z96mz6El/5jObd6rh2Kl49OGb/pvefbZQVxwUV95d4tqz6sDDYsD3U7e+CHO7JvHYAbc2++vPvUvUkj8XJEIGP2GzcNx8tFpbt+iG3TDy8bH1un2+pfhZdDJr3/Q61raJfv2uHeIYnXzA4HOVWLGkzLCV2Pjm8Pnxl2bPWx/LUPY69+uu7bvXXOluJlTqOFo9ZXr8XL1P7PpJ6SV+Bl7Oq0wGv35uNlcf96jRfc3qXmCLppHY88dXPH6dDw0rta5Qy1FWOfMs5OTpp7ehZervh5+w2Dkqn/d68cPDBmS1u8/OaRLePfX3YCO91n3PFOotOwwK07iEDrQH4NIu2TgehaZjTIs/KLJ0fDfFfROEtHKsWcUdIqJOtpMN3upMhyZj7f1+TFbH02Xjw7JtuQosgF6D9gCL6SwdKBtqyfmqNrmMBAJiJlWWpAVj4GYiOJdBLzXL2t6hwuMMGJp/YngQvoFB5xr0aWJSdHEnErnfm+wR5hZmfft8ZVc6XqNcpXGsLrC69RjuEg+pSX4OG8zZW5r9P46bqIX7MgbdoSjQqhvwKoA1SCV0G8IvhSwQqzoFgU2GH4L+i2fL2Khl/xumGbgWaDfkpRTI+aIq3u2nJOAel6lHEBzyL3fce7rjrCGBEPH6JJtrlXI0NFKBBUXLO6sltxxgwYXcgqCGO0AG45G0AsDAn4iDpVmqiDgZ8ocZoHPHePBivlVYGKJUHLU8o6HYxQNNpqNo8AC7l/lu3oyEBHCU//R0zoXZOTEgrQ7NZAACUKAeR/RQCUxCPTbr741o6sAdGYgY6kXaU5RsOLZhTenuanSD2YwnWviyQBQQQQSJaG+CKw4LA52fvEZCu8YIdZUC4K6PEGgVtWjLBHMILjA+IASGQmUnB8kE18+D6CD2J6Kd+Ie+W/48PUCDqQz8D/m5jwh51cWpAvWlNUXebc8ue+RTNtQkK6H3M64EzeZTk+GMWFbpWd/vy7a6s5WcO7W8StCsRtQIitRw7/DXIYOli+sX2LIZNwhKDKFfAuEHq/gkaWblMyp11b2enk9X6KjzfLNSwvjJRviigGrNvfM5tn90z53VStKkAoej4YUGqI9kpNU7a8PqCYHwz5KcTF7FCIzyLKsYBmJfCv4D8ogv2gcKook7Rk8duwR/vptNwaM3b9pfkg/HS69ac5Oz/Zh84X67966dk6e5ORTTwy8G+Qpe9Gzn4ORemEkrCVyQeM/PIuNGgDMwjYS6wn0sGT0ojMTYFKIVwWJMQhBQ1x1xEjXJ+ssiDOyhJ1XLG47UROguOuwOJ+X5iDzjLIoPEWK+fSolLCPWgsSx4JgTPn1a7XzAmTwCbrnTgWmZ/E0VneAmzBeKMQgtfVIy2CuUASqnG3j7dlF6NIihL97CXUctBv5PpCN53Idwj5oW3uefOrrCjT8Vw91COqjT9sFoh/UvQDFAmUAWkBW5hULhsSSqAO1fGUZYTc4JTb0wJyGGUu1XYL5f8m6MlU1SGIIX/mwHjhzfwAO7HaKc71b3dvy4JukxxCimO5M67X5ZLWHSHNuAVSZrNK9etyrS/jXaQh3PBxkpwYcHH5PsZAXZmxIGizeJ5LbEkwEMupKh7pFxS/ITUG6Am+balP44D6oLJjs9haUPyGQMMP4p/VAui1zdmqNo9aBDHG7WFC5wctxn3SBoKKQzAnTowEMZyXVcBnZvUW6XYr+QsHubuZuMduySBxl6AsT9R+RTkxjBAXKYRm4wjhHjD+h1WOlxMPcOB1Bb/mvKTc5CV4BaMRlXZYKpWblTZEV1pnqbTWrBQ0KzE860ihXy6rcJJt4IXUtQ1gkEsvLpqeo68umm5QTQt+EjsBPfKnGiy16EI16y/irlxArCiQ0qVXoRcn/NOTgl59x8RbJuLdENpkNFBRUEDe+CYPzioIxHS95tEX1gc4lMI0tpiuLZFXsAnAOaGrF8oNrhnA4xurjFs838TkebMeDmPZPlFWAjcXzBvAqSDyPOEOh/5rBL9iE35zyy3Mu8h8fCFMYEXqgfJkODKhx/k17iIpHCU5QoZiHNJ0cqmFvzEFsPQDfNEqJArZ9C0P5JjZ8wEVHVTo1GeMz9FnjueJOPFQm+rpaOKjJS/NASAVFhhTNG5A9JGMDnN6NJCV1JhbvNxZwYEvmoXjEb1jyIEV7wbwCGUJSapZpwrnN2LKp0UN39dgMqRJUdUG9EjjtAcFquiuEYwp856Dm5JiV8FKl30nyegh9UjDU45kLJItZzmWxlO+I/MtHDh/JeDCNk20ciIYcWfGirF+B57Q1ENPzPe7uO0PwRcFJZv+gROFhWhokcpf5OsNj2cYjwf0sAqUEQkS902jsdq6ZiwY7nAbslkWKGaU2oOK13365UJAeNmCs2J+XAWmHgegMrEfsx7oG74TWBzwhKKpE6Eqlga8oUAc7UXzteQjZK0gBLXrO74zlw8enuMBcRLIcSiQGMRVEYvnNMbDDHlAzktU41QvLhEvoDy1csFoZZ/Ziop7zbGE87Si4OOxRMyFJP2dsXjWfmdZU0Hz8YrvxJriS9B8Plc8DwbioGebDPjFQm/EMqEVZDeVCZroHU7LRFtOuXcBgkIxKBbkKUOHnkZw0mVOqiuiOajuEuRIcZiIH4VeHCSsgCDuhQtl0qJKIuyIw1hUSWZRJb1BQ5fkTOzKuqT0T7pkLIzZ1Bycl+uSTosuCdj/agHpk7Kwx1N4n++UGJkcxphj+FiQThhzD0Qb6HSeiV9lFjWNDIC6TK7qb7n4QUegM8E1CkpzAgqsddVgEHTcENzdksYjrHZK3Bz2f09LDUhR2snKaPXErFlUVDgrrF5p4iNq5LC0gD2IuRgNLQb9OBBvgSMGmNVCnlZTjXlNYiJuqMjVy7LsQZokkU0CgPWjWOYZU3P8kqFRmFWg4FJt+qd3GpB1rIIwgtp9LK0NUYzWNozvS6197BRVo6pAQdUo+ufGNH1pPGWExoeGJAwKuOW0nf9o1Ob6Rk1LNpA7bj5mV7Zls/9syzYN0cxzBRM3izJlR0zcLMqYbZi4WZQtm7nfVhRkskpBze3WCzRKfe3aJ6qV3gE7OpNZPe4ZusvjDkfAkVYi3OxnZCKfW6XCkyBtnzSY4rdFTBGS2wgVANkORNxuw2g34VMN97RcKOqhwCv+6zbptiFf7Zr8K6hlzy/tEJw7PRkVMCn77NnD3W7Aywzl9o8DY8bgZYfPHLPPDX8CLx/8G1W0zVoQD4U02zr0YDh/fLO/uoS6nXih6ur4DYlYdZRvUd3fG7fBy5RZFX/v+OoOvFw2e+yJ7xvPxMu/9bfS3i95WSMHfIn+gtgUJD96TOUqUZRo7voAHd6HHwJ5CyqVgsANN8GSQMwqPNOX83e5u4W4qjGlSMsiNkfcdIuJ3MbglhyStBiLpkk9QM+uGPcz/4dIWnQFJD3zv5A0gpxovTYQirIsGC/XQCp3+TQJj49yb5g2euzw7KlsbPbQidmT8ln+0PGDh42bPBausieOEZfjJ44bMTov27jLGzose0w2XI0ZM3h89sTBk8eOzmcPZI8eOSqfjZuYP2rc4FH8Jnvq0GH5bETeUHhp9NTsvElUfcwY9aqRLeBvZzV76vjsYfnZw9Xx4yaNzh89JVsdO3nM/dkTJ7Gh+eqYcZPy1auGq2OGQldGD8278kN13Ai17dUd1Imjx46cxMaOU8dkjxk3cZo6YtxEdag6PHvS6JFjsydiraseVO+flp99eSUxvKg68HTaxKFjRg9XR09SJ8K4h7dQHxgNY5ucD7f5Q/NHjxurwts5o/OhI2xSfvZ4ZjxnOEaWPXxkNv4Op3+yx+ePGgx9GTMUb/Oyp2TnRWCN3+h72+DbbrttcLfuN9/W/Tq1nZo/Tm3XLgIg6ulYdfSYoSOzW44bnw8XeWpu9sSx0E5kPPl4NXTS5InZav6o7CuWjxidD0MWJVjJGP2ocXnDJ6lQNw/nTh09Fr43TR02auhYrDlm3HD4dzhAnI2cPHp49uBc9sDo4fmjWqh8rmFOYEqHW6a0LX4NZip76LBRrOXosSPYVZNg0nGsY8flmzPOeFfo3YlDh4+ePIkjyL/VQ9SkDwISwqjwSvQTPyheHDEa0DLbwF0xAzgMNmIo/DMxe0QedHTo2GHZDF7i+ElTjG3A1ExSJ40a94B6/9Cxwyd1VkcNzRuhwgoZlzcZp7iFWQnmhaDIsYXxIYhuwCjGjLlO9KSF2gYh0ja7UwuALJSPHTYR5grQFlAOHrfspAJ+58GjfBOIFhTBcQMCjBs+XKyRSCWCa2f8GkJ8ZKRgUv5EmCrqyfDr4PPQV0CD7EgFE/uw3Pw6TtoVa5hTenn3RA3oXguOvDgp8D0rWkfeExM9fiqHEnz7/nGw+Nu0UI0lDmCKVL/SNMN4J3E6wlsgAHL4EngNYEdauXXwcFziE2FSL8cYbKLGPLVrYwExvRpFxFrAmpwyeHj2yInZ2ZPok1bapwI5VSdl51+nEhHMm6aOG0szMTY7ezg0aGIzYNYkA5la8OnJh54RUk0aBZg6sckk1YoGNReCWWAgPuIwrF4xWVHVLc0YtaNxasTEcWPMN8Uyq9FuhLBMaoK1hsHsZE+8p+0goP2jR44ei1fiWRvzGV5NJiy5eeBNNzEkYOPGTjLvRXvmPR94yy5iVUUKrqr5DuKYSeSjXzdvpwzNm5xt3kVYwkST9kXVvOeq4YNqfoUoG1Btou9UAd42HwweOnX0JOO1+7OnjQNkaJvd3vryuBEjABsAbYxqiHAcr9uoYyYDxt/P8T8vT+AhodRYxJr7s/MAZ9swK75FCKSYlgx4uW3HNk3Z2KFjGUNyC39utjF2HfzNtsONZHN5fLXrtdbvnvQEq/nnmiz6Kbo9i13xT4UWfb9P4yfVfKEZx0Lz31OaAqU28dcBf2f9EWLdbh7LLjZNYfvvaMK+vuY8u/+rcpa58nGmF9/AhvX/m2385mW2fuh21nlsI3agb1fW21HBYk62YulL97NT9f5mTd9IZ8e7vMDOXzuTddvYij19YjZ7u/F4pk8fzD5b0ondNqsTe/pcJ7Zg8GyW8ccmdqHBdeyb6idZ/Ao7S2hdyWLvXsDGNBjDPpnensXsasJ69FvPnh2hsZYnB7P3m0xmP576iF3/0C/s905OtvTW+eyv3JOswRuDmWvQItZGuZ09dLEHq3o5l6lln7D251ax71+sx+4buoS50n5ij6zMZsHkwWxR1ihWdLiaNZnUlzkcbdnO21PYx2snsYeODmG5C8tZnW092Z6RW1nM8SPsrlnN2IIp29jz6U+wbq9/zercsZ8918XO7M5q1m66xrZcfZyt6PcN2/jw1azx9VtZ/dxKtvrCfezaBp1Z4dmd7JdH67GCYj/LaVTAPh37J2vT8gGWct0N7J3kD9nWOs+wV7dtYS366szDBrE5D/dg309oyZ76cBVrdz9jbx8oYG+/8CTrMPBT9nmX31ipL5X1nXKRDX+mGRv/+ctsWMEF9uC6O1jtlGOsvPft7LrPvmAvzO7IGjXcxT6b/wC7e0BDxhq8x36JTWN19n7LVretZiPq57CVdwxlr/zVk00vPMwC2evZ1cfnsZ/CQ1jltj0sr30MG6QdYrW++Zzded037JunlrIDgQyWMec4O3pnX/bhzquZ6/tarOLhXax2+S3s13ovsNSKe1irpGvYrMT72axeEjv/2D3s1XWFrP6Js6xXnxuYb+RB9tLXh9lrg7uynKF7WWzGGnZw5dvM8fxZdu8Dhax0yyw2NHMumz9pKnt94d1s3OebWMvnh7Fz4V1s0YxK1njzSDZwZ3e284v2LGPtAbZl6CKW+PEDzNY4mSX2eIptu2sb27G9G+v75hLGav/KDt3wKmva+0d26VMfYx9cZPWX72bj955hSV3Os9O/FLG3jm1lH13IYMvsy9nmCV1Yq5i3mLv7r2xu4tPsZfUh1uqd1azn0i3soatbM8/AMWziC8Us91gD1nbXE2xarT5Mn3aUnft2Hju+/El29KfZbGXbJ9ncn3PZ4MHt2cZLcazXqrfZyDV5bMLErmzRoKvZ6pQNrOzHGLao7VXs9/xOrI09nXk9ErvRNYq1OHMn6/lSMcs/JrNNnzVivz/8PBvbayJbXauSPbb8efb2kt/Y/tv6s09izzJ1RTt2/sbp7E0Q077uMphlDVLYI/MK2cBbm7IOw8vZmMM+dnWvq9k9N01mN084xLoPGMvcMZtZs/OjWfKIT1kT5zNskO0W9vZ1X7GTU7azR/+ozXrnPszqNXmfPTG6Kftw9yvs1eQBrPhoDpv7xTzWYuItzLbmA/aAczn7tc14xi42YScnrGUjtvRmwyuuZ09+PYuVak+yG5ZfYt45C1lb/Ru2tNMz7OvxC1nt9ceY69vrWEqH5uzeoiC7u2gZ8yUsZfHHD7O8otfZV9U3so7F8eyu1Cns/udS2NBdG9lH895jvqxN7MBZG+s9uQk79e5v7KvARhab/BKb17g1Gz5rCou5rh2LW16X9e/8EqtXuoW9/vNr7N7GiWzMlr6s5YNPs/Lbn2SKNovFVP3GmmctZGParmSd3nYyj5rCDm+9h51fuo19+OqN7Oadz7EXOuxhP73Ynr28dDn7uusoVmfYN2zKwko2asGt7OJXHdhrJS+zb1PaMrhgnr++ZMP7jmA/29ezptlt2B23h1nP6s4s54/32OQPfmUZy75lLxcB5V/4G7PtSmF/Bhzsix/qsevfWsPuSFvM2u+JYTd3PcGSPljD2jV8h1W9VJf1y17LDmx+jrm1eHbP1D2s4R9T2EMLbGxe7Ynsw+dvY+PGHmWVpxh7qs+dbNuX69lLI95nUz75hO2X67E3fmnJFq7czLa++gCb0+tL9vugIPuw6Bx7pao1+/r0KqbdW8b2fTOGFX/UgDX76l1WelVnxl5fxV69bRl79w4ba9rybXZj0XT2pfMFNuWlOPbQXSWsVmIzdmR9S/bnj5fYvK/+ZvM+uMR+mJLHHC9eZF2KxrNHxqawS49Ws4wuTjZ0ZDvWLHUO67vpJKyn19niMWPZ4yM7sbbhe9jsz3uxNt/WYh+1vIFdNfRa9vH4vazNrg0snHeJrWEhZs/7gd39dZD5x/Vk9yceYO/dO5uNH9qb5d5ewVbeKrFbBnZg9T9dz9r9so0ljR3MBrX5gT3S6kVW782trOTq9sy1fg07+QbQqN/9bPHoH1iT6geYRykCut6S9dsTZOpzK9lboYOs9aBY9vYfXVnCl7vYwx/sY099tZm9XHsT2xmawVw597JWA2uzJmwgK0yuYt8557Bk93D2hL6IPfrBN+zLS81Y7lXvsofmXcPsv/7N3gs/y0bl9GN9mq1l/bbdzVpeKGOf372Cnfvocebtu4ipnZ9na+4YzJK1N1hRx8fZblViE76ewz7+5l0WHnKe9c1OYJIzly1c9wp7s3wf6z+wF6v/Vxx7fOJWVuq4jpVnXcscRx5iFd13s5ub/sk+27mDHf9VZwXDv2FPDT/MvvigLVvz5Fb2wJ2H2Ojvt7OqL5PY+50zWY/UHmzg5MHswKbzbOzSD9krrQaxuG4/s/QuXdnQbY+yppdOsGOf/coCBTvZuCXXMlfFdlb9+SI2NucoW3fpQ7bMtZkVDMpnua++yfaMfYZ1mfgQ+zAhh/3+yYus6aRv2Tsfv8/Ws/7s6Jtelv9+I/bjw0NY/uH5zJvSgs1I9bDpI5YzqWkttvrBKezSpQ/Y7d0r2RfAu09/kcQWvP8e2/bkRdZ2bRP2y9itbPn29uzw2tvZ22vfYZ/sjmOJ81qycXdcw1rcPo+t3Ps9+0x9j+Xe9xLr0uxpljB4N7vk7sO+O/cXe+y6MezonBbsxKHZ7OLbL7LKM/tZq2s/Zq07DWUd/d1Y2hc72IyLseyvPjmsdfphdtvbs9nNKxeyAYHdrNnAI6z8w8+Yu84TrO74DWz048NZ47uHMO3WM6wwIZ6deyeBXdx1nl1T1hL+nmHHB+1mX983hI187Cm2tF0l+7j2Bjb0zqfYd3eUsf6zPmSHu/jY1xN6sZbpX7PXU0uYv0UPdtevn7MvHlzBnh1QzvrN+ZPd7rjIfpz2GpsXaM86vhpgI5cdYQOPv8RmNu7Idh57ivX3rmEr273BXvw8jo2292LZb1axwrkvsLk3Pcn+2N+e+Ze+xR6a2Yet+MTPslYfYUd6DmTf5XdmI091ZX8/8y2779Bg9tDINez9Vx5kA38LseZzGzL9/YHsrrEu5m82h3XqOYvN+/4n9uOzh1jvv7JY9e0nWHr8Trb9rvls+Z/N2cHN21n89k/YV3e/xnpun8MeueF+5p9zHWsxbTnzDX2UNbvpIVbUoi67IZzI5jYuZlMz57G1235gP371ENvWeQtrfO4k+30k4MDSMMsubc6uX/YG21TgZmv6H2FNvh7GRn/3NVu1vA5b2/RxNmpvBov5+W3WbbXKbl6xk42fOYxNL2jI4t+7mr1w/jGWfPsx5v/Fxd4BmWbc9L7suTr92Tt/vMxmfvsZe+LroaxWexm+uZrNCpWwiT+PYZ0WPchmbniR5V59L+vR5B4Qh39mB9gD7OK5gUy6qy+rmFBkFX6zMOIEL1p2y++CUvOKHhcy0YDdf/fU6/B+VlpVJ6ynXvVgR7wPzPy+Pdav9+voa7mfzcgsI4CBMfT7mRLufN2zZat+92zadAktg99qmQO4J/eS5rU/wZwktfetGYlu4vy9HV25v9BPWqNtM6s3hfdq75zzfO7KfUXbfUuPAy+/OUub3fnmpyo+H1hDbq/Sxobn1u133VOZ17b768Xrf6vUBh05/HTSkAllQ4se6LLqdKW2f8SjvgfvKy57pHDs8ZTvK7Wk30Zee+uBhZn5j6QcXPdFpfbnY380LNq7oOyb375umruvUhu646ehN/8+JHPHU5NTu39Uqa082O6eH0qLM2f9+uHOLh9UamMemjXo+VVPZsbP+yPvzncqtYuVl5bWfeexzN97Tmy+9BX43tOtx1//QZfM0P6DV58urdTcY4vnXaPklKUd/Pv1EU9VanGbWje79fbHy/rfk7hPWlapDTx588LKolvKdrfNK980v1Krde7T9xp+vKSsouWLr62aWam9PvDeE98fLMrs/9hzO1Y8WKn1WvbcyZS0orKH+j+cuWFipXb91d8MrGqwuOzkooUd/8ip1MK3JWkL5y3InLxr3Kl7hlVqjU8lTHn6iyfKDt1rm11xT6U2pHXnLr+fXpX50nuj2j46oFJ7puOcXTOPLS6r98XFwC19K7VFW5/vpo+bn/nZwvvnXtejUnvY9sM6+4NFmU8ceXhJb61SW7527feXHnsis+P9k8c+2BHKe+WfTb3v0Uzt+Tf77W1bqZ091mBF855FmV8XHM3u3rxSu881QXtowxNlM4ad/+7bRpVa25djxnz3+8zM775pcP6Z+gD/8Li6T/mvLyv+4st9hamV2tuxnokzOyzIdCs/PP9IYqW2eNfeeUuTx2be3rrLi697KrV3X17Xd3LfWZkp69vG/u2o1G7Kf+Wo1HVOZtvDN10cL1VqfS4cHNTp68WZ1bWGv+m6eEaz3fPYdUWlc8p+Wb108Pbfzmijbrlx9899lpbterFzhxd+OaM91rJ/2gXnyrIRh+1jXjt9RjvQfnmX4/snlP2++sdrvjp2RktJ2/tWnTory35cm7S15fdntDE3NXuh1+pHMgPXJN70/DdntPmjMx4ckrisLL3oFVv3L89o98yr3WvxC3eWNWv1uz/2szNa2qreI59qUVD25Npbvji//4yW8MqWIT8PuyGz5byhQ1x7z2iVwx3XxYx4IvMOVu9nfecZbZpS8uV3u8dm7svc/E7owzNam8R47bHqZZnfHPy8qtnWM9q61x/cuLd4SmaTZu0//TJ8RnugYsCpTfWWZXq/vrTyzTIYT+kEds3yxWUvtHhmypvvndF6ly47svubR8u6jvgk9OW7Z7TBHeM3ffjN1LKZ/Z65vfnbZ7Tf7n3odI/EOWXxSwftXPMGvP/5pVT7tcsyv2zyTvuer5/R7E/Nb71+xUOZlz568lDiq2e0mAHpR78bVpzZdECvr50vn9FOfljnlkc+uiZzfY+75jd+8Yx2bfnw5j9dvTyzl//VlHEvnNFWT1k5tM8PC8tijkx577vnzmhr+1Zet73dwrJHBnZeN33NGe21E83nTb1tdpm6dfc1PUrPaHfeefvUr/cuK7sqMHBmx9AZbXid6UUv+e7InPTiTYcGlpzRMgL3hSvfWla257rCEc8Gz2gz37vm0VcTc8rCX7onJ8L9mRfHbKgcOaysdd3szDdXn9H6z60YcP2RorLZy/v/8TDcf9Ll7unDG0wtyx98+vhkuF/38ILyPmfmlOXPeK7XKrif/9PA+lfXmVP28ciut5+C+4OHYu7b9XRxpjbom36jof16z/V978jVD5U9Kp2alAz9yS0fOeDS6eWZV29uI/0M9wPzPnv5u1PZmfff/En7X6H/XT95q/X2krlliXW7DGgC472mw3W/vDt6WVnS3ptWzgN41K+u03n2fUVlr37UsEddgNfYOyYevuXQ8rKfl3Z76ou1ZzQ2P+6eka8WZ64cMf+Lj146o719smpz6/WLMr8KNuv64ytntOpj258e8m522cJu79S6Guar2+Bf75r120OZ7R9IWfkazOes6+u/0CBmWdmH1Uvc98B8N62ft2DDi4PKfty+Z12H9We0u94rLvijYV5Z/K07dnV7/4z20h/nAjfcsLTslpu/WT1z0xntxsdGfJ6385Gy9507x/9SfkZrsndJ84uvT8gsriqduWTbGW3jpNjvrj0wJrNhw+/rDNtxRhsWuD9g2/5oWfaPgx4asfuM9mnbo9/PSV+Q2a5ln9NP7YP1tLHs4P6NS8oGXdXlTeVTWG9tzzzddndx5p1vtUl69osz2lt3Txo7e/TszPClaQNzYX29/cxjT+75dmbZg78eDOfC+nu03a6lD9RdmPnqwbtXrj5+Rvvzi/19Fj9UXDbi3UVNnWfOaO+/duT2L7YOLPsrpd+G0K9ntKzfnr8+bk1xWee7flw08Q+A/7JXO577bFRZz/v+OjulGvB1/p25R88sKevjKGmzzl6p7fl6cOzn1fmZBzbfWFwf6M0rK5b++demJWUx9T+/ZwvQo7c8r7d5beykzKdvfeTrp+oAPby0+t6rv38s88F91YNfVqH+XTH7F1fMzrxx/x2tfmlSqY2se3PH1/cMy3znmGP5mNaV2qg6S/Na5I7MHF1ceUTtUKkdeGf3rNT5RWV/bh000A30ddyf1dqgVxeXFcxz9mnZs1Lr/eLkjq95i8vOzvO6Hu1Xqb3gvP75R0rzMx9d89eR1DsrtfhAlvrskpllK2Z9XOv7IfD9pZs/veXuxzIfufor5afRldqNudIrd3WenTnkbelX/6RKrUGXt53+T2eWDX7qoXZPFlRqH3t7Xvdes3llTUvOJ/eYU6kdnNt5iO3d/MzftAXHWhVXahMmPtP/9PZZmbNu+uiv/qsqtaolBxcn/r647MviNaHX1wD9z294dMVri8p+GflYy16vV2ou9SW9bOtjmU3uHnom7f1K7epTL25d3nx25pPv53Zovr1SO/PI/rYvDp+fmdV97D1TgN/+/P11P7zf4bGy5A+efvXSV8CP9izpe928BzIPFz87Y/OxSm3e7iH6Zvttmb9MWNx8y6+VGuvI5YQ2Iz9adsevra6XhIvqPW36095ucfdTIG98Ek6Qfmn01sqPtdU7HD9OHrg9bLiyPiD2gHeRXPJJ2PP14ytXQr0Xuo+kqLQ233QrbdR7i5Z9fdc11dXh8M7PmmXMnlCmVY9ad8Ople+FH9n3+u8zZ6zX9nTfPznp1nfCq7+p2Fp1ze8aK/5pWuHuz8MNTrTImZoE98y75cy4z8PBd/50DTn7m8Yq+id9n/R5+OGFSQ2e3w/3UzM63rPhs/D+t7e7e7+B90XFAwd9Fn7f07pdzyVwz1Kn7JM/CzfsGkhdPQHui4vn7Fz7afiL+s+t7Hcr3N+i3H5Dv0/D2xotfun2dnCflbu1w2+HwslHnsl9KxnL11564ZlD4Zvu/fDW4b+d19jaeZ2Wdj8U7tdiyTsjD8P9hnWdzv18MPxN8T27yt6H+/GLu+194mB4at0vzg59Bu6Dm2rXzzoYfvT2Hom3F8F9UY/KoycOhA/mHtv75DC4r2jTMW35gfCywheOXtUT7ud+uXB7lwPhWd0dXaubwX1xk6bfndgf/nbTm18F4uH+Qq/mYx7fH/78m2t6Lv71HNy/t2qkvj+clfHNJzcchvsVlcv3/bwvvKN0anmXTXDv+yr1uVX7wvOvqthaGIL7DcNu/annvvA1sw81ss+F+6o53QOnPgm7W9ZJ2zsG7tfVntyn5yfhAamdDn5xG9y38V3fbc3e8N2z3+7WpDOWn+jmlfeG/7qQor+j4vsPNA0N2RN+41yXL2c64b74cZtUvju8+O87Bi0+8yt8f97tTdXd4RM3uYNffIr3MxbVnrEr3Hyzr3zIJrjfd3D3x0d3hjd8Obl5o+fgvjixVVb3nWF53+o9gUVwX1Vv1ANrPw6nPzh7+z2T4b5Nr9FjPB+Hj7Z/tffeQXBf3v15dcKOcNahvium9cDy5LcXf/ZRuNGu6r33tob78fdnbsj8KNzbWzL5gVS4H9LhqVWlH4aLO3XpsEOC++D6AW3dH4b1C49vvPnUWXi/0ZSHJ20P73+xjhz7Kd5vWfzQkW3hZpfWr/3jA7hnB/q36LEt/HKa58H0F/F+Vtn8dVvDbd5JHjJxGd73zl2ZtjV8vuSOO/58GO6z1hQPeHRLOHxdvafeGgX3wWkX3vt1c3jT+cWznrkN71tctWPI5vB1ro9fWt8F7tXf7yjcWx5+N+vF5lIzLP+795HM8vDV+u4npqXAfdGNZZvuCIefunigniph+1lPuDp8EHb36tv73Olf4P6PLitqbwqPzl586/nDcB88fPPIPzaGC6bfkdBwO9wPaa1OO/J++ETjXfkFb8B9UcaxreXvhd+t28IjPQv35RPf6vH8hvCm8e8+tG4+3LNX3pIWrQ+/W1Z51fwH8L5j91/y3w1/2famaxcNx/cfHRN33zvhrwc3KX6vP9xXlHxzb6+3wzcduHpNnIbfz+n7Rbu3wl/+4Zu4oAV+f/uFaeqb4bbvnM5oUxfu1ftX9Ih7I/z6NbO//MuJ7R/Iyfvz9fBbuTfHnzlfBeN5oM+iL18N713dbJDjB7hnj/xwuuzlsP+5FsO6HYD78sSseSUvhuuuOFrwQjney+3unPtCeH/7D2e1fh3uiz4bed+E58KdkoIrvnoG77N7z7+3NPztsVtff3khtp8y/PveJeG/Mm5uvfohLD81s3zis+E6i69d+E4O3t966y8DV4Vb/HH6uTN34f2MT+6//olwcYv9e3r3xv68tPCvjKXhF1+t+vDDjnj/h/pQ24XhF6+elpSdQeWDrq0zO9xr0skmjVLx/vQWJXFq+PE3kh02F943mhZjGxKu+2fj3xtUAF1mxbN/rRyn5Z8cuiW9BO+vv1Y/8qjWauWMdT7QQ1jRlm2le5dpe149k/nbVVg+L3nz6qe0Y0lLlB0nQM5hCXsPryvRXn5j19Si1+C+XNp3z/zntKc8z4Tq5sN90eGsWfe+qL2zMnbWks54f0dlTpNXtdtXDYmpkLD+ih9XTF6nrdj4wI/Szp9hfrzfn7/tTU1ZUuA+u/RnnP8FX7d6W9t7718jXrkX7svvePQux7vaM9/c91KLJliec+2UL4Gut8jtMvbsaZjv9JtvePk9TZ72QmjMB3jv3fjR1I3aGFeHMY0XwL167OqkGzZptjsHbVp+J5Z/M6FtbFhbuHpju3caw33WkuYpI8s17djpM7POnwL6s3TmIz03a5uf+GrypW1w32bnnrGNt2gZfeZ46j8O97dsf/5zZavWokvl9qPZcO9rl7n1263agrkfj+zVAe6LHsxt//42rU+bev4bY+C+an9Gp2XbtemVZx85/tVJuE9ttCfnQy10/ZC29V6H++IRpy9kfaS9cOdB7aeZWF73fHnKDm3BpJjKrDvgvui3AU1P7NCa3PhycbMWcJ91QW6/8WNt/9llSUEJ7lmL9J8X7NTSMr9qtPrzE0DvpHv737NLK37jI/tVr8F9ednukU13a633Pnm21SNwP6TXp9f+tlubfOOaM+/fi+U9rtm0eY/WsdexZz68Bu4rPtkgLdyr/XTryNb9vHBfXLs8ZuAn2jOfVz9260/Hgb43SMyL26cVsN2r94bhft+yuA0T9mlxWz/4snwl3I+f82zuoX3aX7UbvtQkH8tvbPdo+/2aa9Vbr7B+cN+r4Ujviv3awC7Zx3s3g/ui3RXVF/ZrQ+Rzj0sOuB817PPBdx3QmpZWDLvq6DHgh8kxbd47oL36zpEH3voA7ofc4JuYelDbctWTI196Cu5TT49p/MBB7Q5H7bPOaXDf5vW/+n16UPMkffbVztvhvqL192euPqTlvttPYr6ftMx7ui7Jk6dnPv52X4W1+UnTB7FeJ8OLMqceWu5lt/ykrX/uszkvFD6W+eq4m51s/E/aTVcNyD15cWjma/Hf/l29+CftUtxdNzWZXlBWtn2Yk637SZO+PNJr1Ob5Zb9tvrc+2/eTlrCs9zPp2qzMLr/ZT1VX/qTd1vJoXVvR9LKiJ+fEMd8x7dZpMRNGVD+UmXhi5MXq1se0Ro9uanyULczMSZjxbXW/Y9oB6ZexS+SxZcVPj4xn449p+U8P2DPh4siya3dM/7N68TFtlu38s5s/mJH50xb17+rXj2nZw3c3rT19fBn7WPu5+pNjWvqCh1wTi4rKptRtfKK68pj22h/PjMkoX5R5vPRpG/Md19rd9GP/A4XzMhe3WFabtTmuzfi1zbsn/p5f9vSkdg52y3Gt7Nrs3HB4XuaH87qqbPxxbfJDCb9mhxeU2aadP1W9+Lh2x67rQ2PZvLJvbWUBtu64FntjRcdv2cNl89M8P1Z/clyzr67uMYHNLbvhsSUXqyuPax3HP7jvoRmzMj8a/Gd95juhKW9/O2VJl3mZ7z3UI4m1OaFNkVfceHNRYeY455mfqvud0FrdX/1F1fTFZfsTM7+pHndCe79j4ydemjm+zDu/+7nqxSe0yrXDl6QVPVrWpdWKr6tfP6F1WHb3/IqsR8tG/NUbxo/4+9Rm114ts//Tv6is6oQWe8/cJi9p88sc67onMN9J7fYv71zZC/SGP3/b6GRtTmqpY5rPf/mDhZnT6j3pY7ec1NpMm/r1zr/nZvZqdb4eG39S++rlw9dP0ReX3drurnRWfFJLnLJlthx+rOzGLv2asXUntcFadabt0uiy/fVf+7z6k5Pa2+OLE491mVk21db/THXlSa30m7iKLo6czHu82V9Vx5/S3ott0HGH4+7MO3a+9Hd161NavcyG+fWlaWVH3n/8i+p+p7TVzeaM8lVPK3s6+9lGbPwprUu/Ofu6V4McXuvRP6oXn9L+2LrliQf+Lsjst8t2oPr1U9q25mfPNKkeVtb9Xv1A9SenNP/J686sr84r+zZm2IXqylPave5WTyr6jLLbprzzXXX8aa1OzvrlwzcvyPz+jj9/qW59Wvv5wzaLKv8eXtboh/CR6n6ntck9T5eN0maX/f7egJ+rx53WTlfcVlU6fXbmp4tXwvyf1n5Z+scix6xJmav8V/nZutOaLS51+GOXRpU93WP519WfnNYmnvwo/YPpj2VO2XbpZHXlae3vuatf7fTBY5nNL6yqxXw/axPufm/tkocnZ9b7Pd7L2vysffnR+NHFm+dlboufdrK638+a5+87t3eIu7Psx0ePtGLjf9a6xW/u+1lRYdlLM4/4WfHP2r33Xlq+uCC/bJace7j69Z+16UP92+sVLszs1DOvKdv3s3bbG9VvPivNzTxf3O3H6sqfQS+59cMDbGzm8t9e3lMdD3rs6JZq1qzCsq933PpVdesz2nBX2s7N7KHMylpdz1b3O6P1f3n5urXVEzMT7pt/vHoc6N0fVL4x6bc7yrzVzyaw4jOatMN936Ki2WXdaj/3bTXo8e+oN3zqYFMzSwoT6zLQm5fee/uQC/ItZdtAE2dVZ7SEn64d1C3rkTJ50YPnq+MrNfuSyk5t/+pX9tH8H+uzNpXawIRJZ1+ZMT9z+TUzz1eD3njDR58f0rX5mbk3vXixelylNnnqivRz8v1l+rY/vqteDHrisQfO7X/4gczp31fA/FdqbUsLVtWRxpU9+8MD6Qz0tDde2XvjmRkTMtturfi9urJSu/vR8VIH+9iysUOyz1XHV2lfxqb3fnX6/LI7H5zza3XrKq3izYtbRxc+WVbbe/FSdb8q7Z7lu675O/xk5sy+exQ2vkrbdfsP5bPYzMzju84C/lVpdSd3+ODb6jFl2V96JLauSjvV+KfXCrUlZR0PrpHYvirt99W9pv35cFHmpUtf/lldWaWV53423m57oOyJS++7me8X7X73mNmHih7LHHTuxz+rW/+iVba/NPzP8DOZX6z6FOjvL9prtySOf4Ctylw10A/07xftzDffH/3j0qLMxgOaXKxe/Is2aeJ1R9qwJZl3ZV6fyNb9os2VlKJphSsz1z/b9EL1J79oIxeufvnqP7LL2KH556orf9FO3fPCM+HCZZlr5izwMN9ZLXDPpSW5RaszlRseAfp/VmsXXn1qS/WyzNm/lVVX9zurTWzVavoxaUrmF/6m56vHndWGegqnbLxYmJnZeVkyKz6rNdflzJ3yxLKkYQOT2bqzmtzgbLuZRUvLrrv171PVn5zVzh7p13F69dyyJ17d4GZVZ7Xteptb+lc/Uvb60Qf/qo7/VXsm4765E9iMssLBr8D6/1VLWb9eG1S9pOz2kc972C2/aptmLgjMLHw80//7Xwls/K/a7k+9295nRZnvtb4L4P+r1v+FN1s+oy0v63rgaxtb96v2Xccp43MLH8m84+M3z1d/8qvWNjHs6yw/mJn69jpYf79q6259Y8SYwhWZ516/OoX5zmmNHqkzuMOFkZlNF/QE+n9Ou6H/kYk/SbMyh739+LHqfue0u+e9uWF09bzMisk2wP9z2oCzW556o/zxsmObx1VWLz6nTWzW+WxM1lOZthc++LH69XNa94e94fXVy8u+aeKrzfad067POTJhePnKsqNdquJZ1Tkt/bZH3PMKn8zcf+ORROY7r7VfM2JCtm1I5oNN7LVYm/NazNUN9+4NP1F20/ivTlf3O699XmK3T5Tnlb04YHBl9bjzWuLwj+N+Cj+Vmej7qTYrPq8VV74+Y/v0uZlLu3yssHXntXJPONalry4rq9O7Htt3Xmva86q/ms1YUTbvwQ3HqivPa7bRPxetn768rKY9wrAzDCE7w49hh/A3unngXStXrjyhPbimKT0/0b3XU/f0PhveqjVe0JxV8X2N4G+R/Y0d752d2eKzcNHtHTIavf1nJvdnspS77gxv2v9pWP294rDrufRNPOTAUn5n99oPTPk0POaWdz9dc39DXp5lKb/Q8tFX634a/nTkumd/mP1TGQ8bs5RPfeDxwR8cCld0abpsdJqNv88s5UPStywYeii8e/ZNvVofTuLjrjgfKV87Z04b26FwZ/fMn3/teoT3v9xS3mv0wJuePxgesrz/nA/fUPn7QUt50YpVX/c8GF5atP1Q37uu4uVFlnL1u/ePHj8QPtx8/cr6DzXm5UMs5XO/Sbp73oGwtu6Td5N3pvy38ixL+dRP/tKbHghP+fK2jEZ31+LjVy3lK0ZvXrFjf9g24NiostcbCPhYx//yy/eO3B+uWjuz3YcNGgj4nLOM/7U/Ftj3h0fcbb+0bW1j/n65pbx40tFGpfvCccq56WdyPbw8aCnf9/byq7L2hQtbnnt2Q/uqsv9UXmQpz7pvTOp7n4QfzVz5crM7vAI+lvIhR3a9WrU33Oj1OU+vb9xcwMdSXtVsrLPJ3rCvWhvQr3VtAR9LeXm/XP+9e8Jpo3ZuXPK+X6wLS3lw1Ue/L94dvmb26lH9pjX5b+UVv1rg0zJ/zpZd4cXrF7Rdd3MdXl5uKS8vuvnjX3eGRxTv0Ybd/D7Hv6ClfN3RBmUNd4ZPbu5xZPjCqzb9p/IiS/kt556++9aPw98f2mz7Yn8zsf4s5fvU7GDhjnDMn18VhjcZ8LOUV/jkeS9/FL6zz20Ti7/6j+Wqtf06x+I/+zA84uibpTk/+AT+WeHzwvg21dvDnW7xrb7h2fr/rbzirGX8Jd//2Hh7ePE9zuIF36gCPy3lRbvymvfdFs6ceu3QzZ7a1/+n8qClvLi+enHC1nDnAU36zpn6i6BvlvKqBhdufXxL2LVtQu02ixoJ+FrKh7T+tNn6zeEnShNS1xS1+m/lWdbv7yuY/nl5+Nw9x+c+MTr2+v9UrlrKK75qu+R0OHy2Xem9AyYL/GCWctYc1scH4UxYKC2uaXb9fyqv+MWCv/csHnBfWdjxweA77/DUE/C3lFf06Txm6fvhHS/dc/zaToI+/q/yoKU82Paz7ls3hEfd3rpv04Kk/1ZeZCkf8uP8A1Xvhr+c1O7jDk8K+jXEUq46NGfaO+E77vtw6D2yoH//qzzL2v+0Jz7X3wp/m/TH7i/va/HfylVLeVHpmfbZb4RjShdPua8gWcDfWp5Q3ib29fCSx9rPevaulv+tvKLKUl5nwtddXw7fNP6zHx+cmf7fysst5eVX/3Zn/gvhMyVnr+lxscWm/1QetJb//d6jz5aGX/q78fn18vnM/1ReZClnU+Oemrk6/EPM9ILGRU03/afyIdbxfepMe+/JcKfn/1w2YFGGWF/W9y+uW1u+OPz08wd/K6j/bdl/Klet5b7cZhWF4R+yvvRqR+ts+k/lrEpj//rnf5SXV1rK501O8RVpx5s/szL3I0FfiyzlRcvuvF0t1g78ftRxzxFDvrK+/3HGVb1XaNd47r76/aDgD8xSnnVs3iA9qN32+S/3lidIAj/OWN5vdei1EWu0jEubJk+qJea/yFJevjr5peVrtYcb373v8Wli/FnW8q/3TNr1iubMONzz7Ki6An7Wckd525OvaQ9d93G/Lglxgv7/bFnfPfZf9+Qb2lPPem8fdLXBHy3lFftfOL/pLe3zm7967r4dYv0NsZQHn+x794l3tPr1BmU6Rov+Z1nKy0/GHmTrtat/fubFRfVPc/xklvKsuwbd1+497cuemzrfm9BQwOe0pX+vLtqRs1H7cdTvzYuKk0T/LOVZZdKdc8u0g6/c/eH+HoZ8aClXY2d1+ugDraL7T6+PKm8p+nfaSt87LTke1i7FlvT77BqDvlvLm8x8rPZm7ayz5d6plUK+qThl4V8Npzd/abN2zcqO3R57QcAnaCkvmuMZun+LVvL2jF15zyiCvlrKi1PWXczeqs2beGPDta0/5PDJspSvazfr+iXbtKnvXhowbZag76q1vOSHH5ts1z56ePSPx9uJ8VecjJT7Fn5w8x0falNbZbZY8IkhP1nKx09ekFj1ofad/+kfFyUY828pv6XbI4vmfaTZb1gy3jfC0D8s5azTqdc/2KHtb3HipQHXOwV8reW/H7n77o+1cdXBOzPOOgX9tZRXzM/8edlObbT/9ltumCjoS8UJi/xzzx2H2+7SXvrulZsXXSvk43JLecV1HR/dt0t7N3HAXdtuFPMbtJT7qj78a9xu7UDzJ7ZPPP0Lpz9DLOXFh9Zd/8Ye7dp1Kb83qxbrN8v6/rHquNv2am3O6UOaJG7h86NaytnXP7x6fq+W8NjG7BT/Tt4+s5SveysvfeUnWptvPTtP70oT8D9u0d/6Duk4YZ+25Oafa3319AVB3y3lQ4aObLltn3biZGatBalCPi6ylB9H/NyvpVc9NyzOL9bfEEv5hVd23Zu7X5tR67nf96wy5E9L+ai7h60M79fWb+rZ/+fnDf5qKd8QN6Z78gHt5Ps93v/mUSEfVRyzwO9IQdUHB7Rztlv6/Pm0kG/KLeVDDn73S/JBbUOm/+CDR8X8Bi3lvg+mjMw9qO144Jd1e8YmiPFZytu0e+DWLQe1ezc53h1wXapY35by4582fLvOIe2ZiuLT7X9wifFZyndM2LJowiFt8mcjY/Y2aS3oo7X92s9WfHxIW3M4Nm2eKuRHZikPdnS+FvhUu+uj4TPGfyD0/oqfLPi547bfH/pUq8wadObnV4V8U24pH3LXt5s+/VQ7kr3G1cwdu+n/A8rbaq2NPgEA';
