// sources 1185575438
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
// sss.render draws the diffuse light of these materials without their color, and its depth; two passes scatter it. The
// materials then read the scattered light in place of their own. Specular light, maps, shadows, tone mapping and
// post-processing are three's. Call it again after a resize, for every eye of a headset and every view that is rendered.
import * as THREE from 'three';

// What stands before SHADER in a pass: where it is in the light's texture what the pass reads.
const head = (step, taps, materials) => `precision highp float;
precision highp int;
precision highp sampler2D;
#define MS_SSS_STEP ${step}
#define MS_SSS_TAPS ${taps}
#define MS_SSS_PROFILES ${materials}
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
  // as show no bands at that radius, by the table of ms_sss_shader_constants)
  static async create(renderer, materials, { mmPerUnit = 1000, radius = 40, taps = 0 } = {}) {
    return new Subsurface(renderer, await Kernels.load('Subsurface'), materials, mmPerUnit, taps || Kernels.tapsOf(radius), radius);
  }

  constructor(renderer, kernels, materials, mmPerUnit, taps, radius) {
    if (!materials.length || !renderer.getContext().getExtension('EXT_color_buffer_float')) throw new Error('Subsurface: wants a material, and WebGL 2 with float targets');
    Object.assign(this, { renderer, kernels, mmPerUnit, taps, radius, given: materials, lamp: null, count: materials.length });
    this.materials = materials.map((material, i) => kernels.make(i, material, taps, radius));
    const target = () => new THREE.WebGLRenderTarget(1, 1, { type: THREE.FloatType, minFilter: THREE.NearestFilter, magFilter: THREE.NearestFilter, depthBuffer: false });
    this.light = target();
    this.light.depthBuffer = true;
    this.between = target();
    this.scattered = target();
    this.lampMap = target();
    this.lampMap.depthBuffer = true;
    this.uniforms = {
      sss_mode: { value: 0 }, sss_light: { value: this.light.texture }, sss_scattered: { value: this.scattered.texture }, sss_lamp_map: { value: this.lampMap.texture },
      sss_lamp_matrix: { value: new THREE.Matrix4() }, sss_lamp_range: { value: new THREE.Vector4() }, sss_lamp_direction: { value: new THREE.Vector3() },
      sss_lamp_light: { value: new THREE.Vector3() }, sss_lamp_normal: { value: new THREE.Matrix3() } };
    this.constants = { value: new Float32Array(4) };
    this.passes = [0, 1].map(step => {
      const uniforms = { ms_sss: this.constants, light: { value: this.light.texture }, ms_sss_input: { value: this.between.texture } };
      return new THREE.RawShaderMaterial({
        glslVersion: THREE.GLSL3, uniforms, depthTest: false, depthWrite: false, blending: THREE.NoBlending,
        vertexShader: 'in vec3 position; void main() { gl_Position = vec4(position.xy, 0.0, 1.0); }',
        fragmentShader: head(step, taps, this.count) + SHADER });
    });
    const triangle = new THREE.BufferGeometry().setAttribute('position', new THREE.Float32BufferAttribute([-1, -1, 0, 3, -1, 0, -1, 3, 0], 3));
    this.triangle = new THREE.Mesh(triangle, this.passes[0]);
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
    if (camera.parent === null) camera.updateMatrixWorld();
    const { elements: m } = camera.projectionMatrix, fov = 360 / Math.PI * Math.atan(1 / m[5]);
    this.constants.value = this.kernels.constants(this.taps, this.count, x, y, fov, this.mmPerUnit, -m[8] * x / 2, -m[9] * y / 2);
    renderer.setClearColor(0, 0);
    try {
      this.drawLamp(scene, camera);
      uniforms.sss_mode.value = 1;
      uniforms.sss_light.value = this.between.texture; // a target must not be read
      this.draw(scene, camera, this.light, null, this.black);
      this.passes.forEach((pass, i) => {
        this.triangle.material = pass;
        renderer.setRenderTarget(i ? this.scattered : this.between);
        renderer.render(this.triangle, camera);
      });
    } finally {
      uniforms.sss_mode.value = 0;
      uniforms.sss_light.value = this.light.texture;
      renderer.setRenderTarget(target);
      renderer.setClearColor(color, alpha);
    }
  }

  dispose() {
    for (const t of [this.light, this.between, this.scattered, this.lampMap]) t.dispose();
    for (const m of [...this.passes, ...this.lampMaterials, this.black, this.unseen]) m.dispose();
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
        float f = nearness(there, own, at) * pick(0.2, 0.8, q.x == p.x / 2) * pick(0.2, 0.8, q.y == p.y / 2);
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
const BINARY = 'H4sIAAAAAAACA+X9CXgUxRM4DPfM7JndTTYXJCTA7IIQbhDlMjIZ5FQRD/BGQAhHEu6AoJGEQ+SUcKiAB5sEFW88QQluuBS55FJRUSMqtyQiKB6Yr6q6Z3Y2oD/f//t+7/M9z4fCzkz39HRXV9fVVdVsyMTREmNMelFuNlguLJQKByuFhYVssA3+LZQKBjNGD+C5vbDQeiGqMHyLDZawwFUo/sC1M3LpMK+kQmytgF4q4C0VmN+Ej9kKqVApKCiAO9l4Zm2F0UUBXjj5hdGlAqpdYNQRJYy3jl/DlgqMbhbgNwoHy/QliT5XQD0poHawfwU4qgJ4Mm0aXk+j6vBEGT9OUWx2m4M5HS43s8V4vE6nx2P3MY9Pio2LdcX64xN8rkSfTXImSY5kZqtTN8WXIHnl1HqynBYvpdjS09PrN2jQMFmWJLfb53OrqmKzBVR7sFEg0LjxFVcEmsB/6hWBgNq0SUagUcBml8ZJdrtdkZjX4YJu6RUzW3qct7oco7NHj50wVWaeQaPGjMofNSRv1IPZTHKOmTT6/uwJE1mWe+jYMRPzh4zJn8h05+jsiROHjMhm3Vyjh+RnT4Da7Dr7hFFjRkxkPWzDR+XlsZ7uGInpksfWoXOX3jFH/1bGQdMu5i+CP8yTK8mFjehS9+cGlcb8kgVscpYq6YU5KoN/JuhFRbY+PqYqeNFBdqmKKnWQbfDDOsjQeMCmyrqkM/29BfC6qvhnYjP1PPCCP4e3qdo8z3ptbgC2NM1hfLKC5Qbs8CXWAxq3Q129YU7AoTJVxtYZfgSeq/BJL3TElRNwQq1OObo9J+DiV86cgBu6G6NkyZf9T1VaMRa06Vf0hC/YevhsUNkDf2X46/VK2EMpJ+DDalJQ1n9gvXwSfNGeIXvh1paDX/ZBEzjCDBnegSrwshTwqL6A4oFOsC4sHvvYhfmhPWw28lCGhwCZX1hPn4z18eMe6JSs/8F6iiET7I7Bdx3iuzAmfcp4+LoLv461WygsGLsxGNetiP+5UMNmWq5vpZY+fRIh+iNNQFy3wgFp+t4n+XUN/+OceXNaUM5gMGV+7BuMDgbWhSV5HdhtP3wJ36PGWkHHYZB+jw5jUWNXqrFqbHcm/gxNC0ZuhgXltEC8KC2c1Vof7lO8Nk9tGBJI2nAYyqojYFOyVBugVhBGD12JGRP06zF5uXrbCV0YTL/uviGQoPqhaoIP1ofHA8gQkwMQwWaY13lJ+9SwDT4M7cbjlMabHW6cVRa0do/RFFhGgMgX2709/KkZdSFrKNxSI4XRjZQGo16RrK9gm7pDl1SARSIfq0bYZ7xSqYXM16v1oZavDx9Pn385IHPskT2qS03MgdG7Az7ohw+B5DOAlGQBUkIQAQgVCVrJahJAKxl6ImfhYlATdfkmH67NBC+0mYhVE1UborJMkCe8awtYiIUAsAQPjJnBX1uO7umTFkzWG05Sk8fDBCX0DiQpWXrbgCzjpLHe0OEkXaKO+1TCIuw2IrMK/8vYOT82mQS14UcmUNjU5F7wAszoTQLz1aQcvTWvLOcEcPXAGPwerAJfhN5Rl2XsKDzBd+EyUU3uTYOEJpPVeGzSD0OUzO8DSvzIOBJJOXorvQUOq3ea+Z0EeDEenjWcFJShsxOhvvt6o0cJOXpbXlMhiPCpNKaCAB6ZjHgxGUG/ibNJajyANwk6CPVFiyoVJxCM+QT4OVxsqh8Rx/wy9tojaAKiqIdTRVo4XtVr9vj/8gIihPfqhTjMGP2MdAP8GuupFVaPwe7EADEM+LAqdjLo72GpLfobE5Dhs05VztE1XVP9AKcaaXwwRq9hPdOgstonzYB8IMZsRjJel6G1PtCtGKNbgN1QoHjxUvLsddhshdLDUoHJHypZhCdJyJNo2hms9aBd//vhHL3m4T4EI2m8j2j5dJlzJzvnTsQ/oDfAyiqXWjkT4AtvyBZ06FNz9Kk3EHdzdJBT4DX4SeJv+w3eBi28wVuA6Yk0orLm8pq+QeeGgIu65rwO1/R9CDrXxn8g17fwHk/WawB2nHvpC2wBxBgEuJyP89IchujcEPyXRmTxsYE+XJYxOKXNZRf/vk8hRqQf3MWAt3kCsdh2AHmfnTNKWI2x+I0N/9ZJm+r733X0p3ezf611K80MzsiN8BPTQe4NP94OcncO4SwLhNcs5BCuYCaIHR74hA2RB0CWA7Ou9EKK5dO9yLVj9QXwGwu4DWVe1UFlHizzqDGquxeirMBFLGF6OXQ2wCxwAJix+dexxvl9BuGkMT0lJ/LE7Pmd/Kc/7/LNli4/+wTv8t5Il234IRv/TFS3vYoH23N1VjJ4Q6qloSIxdtWKXVS5EwfbVfydtpZ3vhIfb5tjEbgqWUTi+s7pxvUkF8oPS4UKSMe2AulheLExDjJgV6UWSgrIWxKsAxCtJOShLlVGlA64Vam5rALkYBj6mmb+g9hkABAUOC/8vS8NXnepzusDHouwZUMYKhlyeg8EHTS0vm8wZgNvcQNMUAxHz7SAz/s/ylWludw4iPdF2kBozOSXgVgAQJzXfFKtqTEbSuApC8QB8dwAxNW9ARg39E31pMGovNiUGrRvAF4V2331uGtjPi+r0Eq7r2/wyKlb1n+ghUpVO/9s0JXWfX3WjCMfLXcBt09QE1TvsDT4Nw6YuhhgHC5spGgMJOGiv5QO8qEMZK/WW6QK8BZ+Lem1Xt89mHQWvkYXr30OXwsmlr3bCeoBu1X9pUANnetguExNhKcHM1DobaH4g34VqgWTOsl7My4DWXbdoHFz21KvcdZcabymx5Q21ISyAHYhvgxAwTv3UAd5WTN+vRo6egE/Fftu0N1JPoeXiSDiJZaWQieWQy2AWmJZMBGewIPqDACuQuRJAX6j/5UBXAgvnfpBvvhxmrouU93LgvZOMhKFOc1yVKf+Ci8NxizmXTWmF+rAkOy4+JY1W4YvhwfS6qNL1f54J3iOuGzLCSq6l1Y1H2gQ6HtFhupAyCVSa6Q/yPB2BB8AcgE7vgGd+SEDAAsEFgZgcBA+EKCzQRrCYRiNhKNR9AzsLQ7AqR/PgDJajvBIjeEDwy/58N+kCJkHjURNgg4zD7SvIKcbH3DSyncCmshAph1qPMiLCkgGDqAAl9ZC5udQkzaUBhzY6XiA+HacEQdcbMWLhO6hzaf+vqH3250tl8PSoHhXhud7h1NCpklLHJSrhwXrrJZyg7IgBDJC2htUABwSv0npJB8Xl2on+bRkwIboYZCvh3tVhf/mEGcJOsQdwEzqSZKcE8gRUBNU/J5bQh+KkCLOYXlL9yDHAxaJ7dgCbvP5/+aTbqo3GOu5/53DyEgqsVPuDZ0VFxFJ3rOjc6hnUd1yGN0yr6kreHnVdQN5cw5oR7W089KTfIRRBBo0RhAygdjTZJLcrZhDVkgqEA/+fayRIaSoKJ4fxo/lAD02RBDeh5MLeB8iIohM8pru6kmoaCO6rgiWCR3EHl5gOfxLxSVPbmIdEUh6teWZzh8tly6tVixdUm298Qj6rfFHa+GReOE4I2Txb6C50NdIOShkZazjt3PwVk8icYE/+Q4npwNpxAeX0eVgVba2fyfcQts3Q4UKXqEI8Fb/ir8XwutjC+m6QuBzY2i6NzzeG+nVoUv7vJ33LH097wdIHDqwQ/8C4nI2BFu1FOGjxbINl5j0sFyAtIMbJ2QULhk2/BdMRgU0rCKVwqViEwzFjtIoPUsJOjZEKJTAubSgs7Pip3VnJ/qnKutwFjd07/zMraU9v10MjMOg6KX+KuxM0KW6QqVlgCcckyVc2BYUFk04Nhh1+OdZENE5BS9tRu94dZvqAOrVGOvJb2KBtgxr+Zd0koH26C1zVMV8zKduCRK7GsUO0CBpHSQKmYsTKCpcYFxUCDqQXWUEnaidk4hRkRFkCDkHUg49dIbl5ZDyzjgddxlcjl5MD9p6dBDiLBAOEN9IFCCxYGnARZzeDVVdnWQVm2+OpFIm4rWsE0jvaEyBh9sz4I6GfTwDOui47q4vYIUTM2Jp+PhCBgxnHE0ItG5/HOl8Om/wcEYnuaXqAJKG6oPJGxyCeEEDneSruI2JBIwIVO0bInKE6gY+bg/EwFRERhC0L73Ode012rIIStg3lFxOOFHdpbXbWoKamkONwQlyII9rrLo4Aw6AshiQgL9B/5GfdcpBOw9eM33rYQlHsAyHoOhbWQ7vDdP38oKg63H+xMVlrrTInWDZAAXgxxLnx56NiiwXegrQYgFVBuvwTwhNhuz6oJJ2Xe/vVmbBk+4AmzRcZ8B80jYEbOZwdWgtd13QrtpD/iOILiWiCAYfcESgIumFEy9XDdZDwBmRCV2RS3fkMiZyicqVK9KsrDvHrxO3sRUh/EApPFQm134YAqHUVlbCK9gjDShppWbj5nPGhqUF7SE0TcIS9OK7jpKgrzQYq8aEAig4e1fBHIYAcWNVX6nqCQU8pCsHkQAZUg5a54CWA3fPQ31Q9aC4OBIu3WoMXg5TLaKOC58MVkn3G2cuU2zxTUD1oquWLYGHqr4My9PRPpX/5jJY7vme6ZIkFyK2IM/XmX8+QtfH9JVSQMIJ80OfnD2JQcq6rTeUdNJB79cdPdPiUIaRqAC1GqztArRAhUS6Pi2AJAf1alRRZHyiSnmksuvyaN2Rk4esSUJ1/7hdUgxFf69sSitcDCHLlSLY3oHHyShtVbuhh1AMdBwY2bwfH/1950cLf/1IkHsg5hZ+VJvyV0ZKgR91O7lixu6lOz9Z9qF4VmR51pM/6kQ8raVgWYc4i1PF7QV+21jczuaMqW2Eiz1WAS1ncDamoty8npi8vm0e1UT78FnOwZDJ7eBPx8HlB/yyWOKMtPY4QhH+tt1SWmEAwcKUL1NcGSmeI5vFy43iItksXi7RADPEANdzxpkiWPohYunpKKqIJxd4BZu4/YZz7bU4ih38ei9el3FAVeP1cn5djIasUOTLayIdW2B0bLv5bNZ6c6hyDq2I7N27N1mWqK5cH7Sl8V4sl6lTLtGp9fzW6PJj/PtrZRKt9BhDEAgqaOHwoSKvcKsTQ0sTCdQdiCAidj6zyCpgItriqt4rG+KD4nlXAlqpFAhcVy/ZZ+EWZ7Q9tFBIoaFF6cI7YKMM+oRXzuGcO9qzfXwFoDquwEuqHYeBhinVSVeqA0TgSzdnNi+KMoGR2qrmBBht9AQlUkRQ4zHFnulOxVkoF8imTtEsN+gyVikSOU42gm6fUI3gY27g7fixc8tqr1ng+v7ZRn3oHeg+/hmW9x1R7x+v/T5+EVY9ESMVZT1sAVg6tPIYSW1uYdSLambWJaTDjsTJDcTJTeQKVUMARMALv2jk9YLW7PTPEv1CMufFiXfjeywYeyNK8WosynUu1Y3ijEv1cTDTJ1Wf/iupQi4LmL1mb53+RUbLqhcoIW/aA7TdA32BmnolWqi8QPfRNBr09TJs3RK3uwPhvB6n36V60EjpMoyUxnhXLqOPRxkpYWQgEQLLtfvn0Tza8oU5xw01K5rl8O75H6VpdyP9DPhUVwvlULNgHP7ubVYa8Bs7bHwWiPI78RoUQxi2gyh9TF4/GJhTjRkDui4MXAo48K6Pj8zzRCVwCw8NS/EorTUOJGATKQFQ2wiRm8mNO8rYB6C58psodEAXmynHm3UEkuoGaZRLJQlLqUhvnKP636VLElN4oZSGMqEbhFU+Om7tCiaI1prLlc06Adl189rx0JQXnsdBOzCjqg2+aoNfhX9dz4RFJS4z4GtqwgY0ieDSdeMIXdhtDkSER8w4nMA8NEbCmvM/QhBF+Zfq+QiJOB9UncAJ83P8xVTFiVZKJ9nBXbDMjCXo9jzlcdpJvfc9LE1zwF9jKV5guUGnaRqH1Q6TKQdixOZPjC6jsd+tK7jZ4gp4sK9u3BCRR0PFGHEVo3sD+EXANJeQ61RbhtwWqsBPEjTr1A81R/m3k/8AoRM8WIMPEGU4whimP5hNbiBAmgn8QliiGdc5vIZ0LJE6onrvAZzQbSAVOXQb4O0T8y5d7m5ayVgDMXvZJSvZqVe0EMzCqa9vAfNA9Nypb4drD9A0fos1Qi3g8beczRbj9TnOXNfCtYpsYDle2JA0AGwQPten8QbWYO3iFgAu1SG4QgxxhBh4vhyeM/3QbqHzAHS6TYcLf0cFPwJYxPTDhyVABx8pD+un4O4JtqbG5MCyWWDLMeyGQNjRWm+5j0FpO0ZYv5zG87+a47WUI+aBN0aTZKAbdA0WnY6aMvYBoN24E3/NlSPe9ZlvzBHYB0Uu/1y84avC2Vze2wzkVieK7jFpQJDgSboay0tj0h4PxPFLmGl1aQAk1jdhRStv4m7km4FErK0GkviWCJAL0N52nO0zPhBL0wY9Ur2PB2I99GE9Q2+MkPfr9p5pZL9Ixikky2GgDq8i7uryu138LgXfSsF5aC5nBlLxJyMAU9BMyQqk4d3IQDr+3Biojz95gQb4My7QEH8KAir+TAkE4AX5qkAQ6NNpEOVsnErRireTOSOGX6vBjiBo2/XDLIcvGJ/q6Q1XIEl4eueI+igbBvjlQbj0quoy/nLDTiDd2bHnagNeDkNSU/glKGNqXV6vficksEh00nkZ0ME6vCgNSaAdSWBEuXKBupXGK2bkIPPJFx0BwliPv5aMxBBpr5rKi4AOxfIrIJBJvFJcJ3IJiEdSaFf9SAntagISQruayCtXA1NQ4IMx14MebSI27gfi4heMxXUTXxpIbRRc2fkgV8D6I1nJBehM1zhE3FtEIxvIe3mAkHoKLBJkAWTyQv7uBhbWTMbqHtohk9BuiHueiClO9NKI0YsdeSqRruWOnKCHf8cFT+GRuIl8AlZSHq4nm2gVOCk8Et8jMuNGo6xLJ65IG/qM0x5cqe04bXQi3TWIc4znhGxHo5BChqGIS0vQIWrQ5iDxXn8UyeSypItoMX6Fk8+WQU/EhIAcGf6CUAAjaAH6g3NDacDLDT6uSDWv6tlQFvCCcLUOENKL0gvooN6IlgxPAGJeXMEwvnzcUscZksX2F/AMMrFfT9ufx8nqiDvUCt99UvK4MIub+DDlMgqLXlVZN8zHZwWLepJQylAiAjYHEhE17F1h9EEfSh19iTs4IGCmoLeAg+xnxAHsxAFmPoaQcZg7WQ6UQ0xQn1VkL4AZFWSdcQXTBqIQ6NtopsQNCf3pjBz/4iJzOw6ooF1f4AXdMwcJLUyDCXUU/3BTEPEasIJYYGFvUwRUAB/l/GBsDjauwk8cfoGbf8TmqXSj4THggQpEuYV5iOG92BPlPg3k18RMO5cfn6g5uMqwibY5ahzuqIjX7ThqeDKnmflB1YuiFlqvAnFqDO3lxqEMJep7c6AoDp0G4tRYFORjBarSmB344xDCpNg8VThi4mJXkDCAILY3g9uFWtLdoYygX/ULU1EmwjaUgSsFEAgdbZ4mcK/mj+R8TvwUIm7wcnUG7zWClHZUXdhBBQkn9JAgX3sItssOwVMs222FuHuJVkaYd8tkiq1s3JbFqXLgpgSC2GISMhwF3NQPS4FeGJBUG7qMgVwho/LTM22dGoMyokcsMr4QaU8KJDOy86Lo6kZR3oUGHiQdgEBkakFaJY/uzd0sZIudKRxa0f3nkd/PeefCD11xERDHRGVDdZgoIjYLUKJ/N+ChfQfAKb6Jdsm2t6fILrsLnQURhz3nJTYTmxCX/rrUZqIbSivaBKFZlTaiVFtaEJaufynJNjYasjcHDXSoXfmXGY+JMKI8QPRKqCPYDKBXDKgB3COFnNVQ7LLRGkTV04XEw4HT6iDMRG2TlpySD5CEFsyVJ3AdWwOMVfJzUD21ifVIyoMDVAqZvuOo9R2gPdgTdBoKysLlBaa3t2gPZBk3oZfZMKraftqC8xAqxak2NMQBn0NlO171l0BlGxL/vfxRgppQGkxEfiKZ9yELpXWYlZLUREtBMLmkLFiH/I7Ivo0Wn5uxhRI1GVpbW2i2piaZr4VLQ2WBBBxEHSiI9lUji5QfPaGgYf9KrKEmhErxN1Sm+v17ccr8+/BfgJDHBFE8yGl2hI+d5sGNM+OOJg0x/sc5g0KPA7JPICWx+HCW22VgdwUW/xwrCnITAGkNJM8fwH9xinumcREXMfPVx0nmtIr6AjSEYraAizDBBfNNOqaba7gu8fqCJ7jI6rc6XLhwsbiIusCCV7jWjMziJmoClnBjFPS5y4XR0l+LeEuRHT3ankXPUqk3qf4KXiDAp+RwyUCwTRcKM+SWGfNvu5cRA/RQ8y579259GKpmqArFoHbNSro//lmT457W8UglUEBWY3ALi0aeZfQXxrbnMd5fi3uMHSgGKn9i5L0E4sMscEnM5SVPINwTgOWch65/0QPJIAcpWBE0mO4nF4Q639W1Wc9hl/b+X7cuqct38i735wC/2ey5pJ9YzHu+N6rnl5k07LJBVZlwmbHM2JFLdUD0y2krir8SE2rxh3Fa/GFcnj8lyWZxd7YbZjgScVQpLegIOIU+i4JfrCxL0KdC4qNvHd2VegOOFQlCXsDJ0VbRC3EzCxiQA01RfaAJ/xNEMp0oIaArGfBI3MHSZejh2bnYEXuUbQaXCwo+fNvMia8Uo9mEmkWxysndoQmqyFkV7negkCC7DJW9p4FpKICTXJpFDuOkX3tk6bo8myS7TOxULpAKDe83iWM42fARoclHGag2kUSZHPeCSD/yhDHSUYpuEapSWtI9pVX3/n8G3FmloBdAb0toD9yFfo9AioOMG8q5FRNFDiBacGWhl85Ssj/Cw1BpCEk5rSqXnkKUyE5EC4UetJxJhNmenhL1HDhIL0TvOI/hO853HMQV53FSmirH09ihnnji30lO7x/agI3K/0TEmCBi/8BH9UoibacEaZN7Bl1pAbfgrjg7BtGytnIJzdN/Q2OE/hE5J0ADpAPQmzHR5E68GWXQo72XsTn6uD60yNFvE8R8br6EF33cGwruYonJ8ZVOXM2kNGRLjjcpUjYxpohTcuSWSmmJ44SofmFhQcW4gyyokRpPT3HQndDtClekU43rIF9l0oA4tFwCsNL0ssW1Fimn3y4kBbH4EwuioIRCN2dJXtAKYXg+/AGdG4uA6Bm7ZYCjESnF5ZP4TpMfZRsZlMqgy7Bb0fNiBTR81XhG9JFG5uf8QY7mD88W1+IPtclJP0kuFBhIRBfUUM60mH83VolDoetpehiUBHIuw/AG+C128B2yNFWKn05Y6vH0FuhN7VlRG+EvRdrExapEkF0VDSlmQ28pNmipwF6oFBjN8MWBEMBttZWoPZXilj1JVWghpvXuBFYQhFXoJrMaJ4Tm+oohtmjZVAW8w/Xu0oseJnHKS1gW8EVIaC9yEbeTZuoNlZb5K7GHqJV6SwUBSc0qLaOtUJwKX7SLvQ9myytewktR6soyWgKpxyva6ZxVCkMqQyHarXpI8EGjKwnrIPPEADORKY5A8j/FzXhchI2hwaGc4CbIQnUkd8EYlagRUS2AsVSqxuASwp5TlRzjziqzlcI3OUkLenFNeCM8lHyYCKweotVINRGZnUK29+QDb+JkGUgxh7hiUF5VohWqEMVTOHcvjBPRKzbgUIyUISDXk0FFIp9wm+XdoD0tiGQUWE9aEMgd1LueFpBng2JHz1A7eYf+D1xBIGB0DlnxBa2XSY4PurltR6CM00QZTy2U8aKdGl5zGyjjU934E8vf4whjh3mH/xBdfqBtCvIWtam+sqCPPxEN7gUu4jNxoiyq7LhWGgr40A3YS7vtJXxC0MYE1Bqtw0HPJSjhsaCECyoRIoDSivIJ347zdcYxqh4TaWKgqw41zkAGC1ukXYxolgcVrZhTgnUMDkhNW1cAYUxMNMYIU71iskNzfSPRMMU3itRgghbhULC3Bj6g9QUNTJL/aeKGniWKzU5CgWQ1YinmRp8FJ7iD8jPG5qWQEQAB7CAACQSgOio8cEYGzzUXk/ugK6B5oyq8IxYfDpk0e8ApRF8n4XDp8Kj39Q+5AcAVdKNHhUsoNuSaq7qMJtWoBnoI6djV/a5fLmxuOOY5idQpkEBL4NmGjZ9/8W3BV9eWDhPbsbhZZFXjPGaruP0W1TKur6hWJWwV6sHzWo0Ld0+X0MxIvOLTyR3fOdQ9S+LQtEjCWrwhsVa7TJHViISgmcedFOFVClyr+h8Uf3xBjKYTTptswntIWlCupWFGs367KndW/JZvnCPOaK8tlEjcskU2LH+Ie4FFGhYuHbyFv+Zfst9jSLYKEg6nuILx/P47AFpIcgEnyk74iItyJIarJGrTUy5tK0La3l1b2kZJm799UDjTOUw4DM5aHXRbwrXksmAMbqO7TZeCYVw5UOVatk35JfK1FLZNlGbIruJMs4jrLiGuV/4+FRbxcehClMSuC8FbF65K3Lvan8MBquQIY4cT9yC5iZCeAZ+IKeMUSRbPPUKZE6htw+AFW8BjUhAryhkThtuTOGUl0csQfWXI7xu7A3Ay+bUBMa3U/6WwMphgrNZCoGXix4B7Var0GZe/lEtMQHPKBO1wCu3ToLkuffk+FPSEYuo0TXYVGrQnkfWxF8mh65CASShquFS5FEYAIpl/pWhWAQmYG6LoeQR0Nn2Oi4xJvGcpQrZ0oWzpFD3pLXgy6HuKj+/Frj9BYqdL3/XGxwxlU5d+6LsTZMoEsSeQE/DDb6WKoYIeivDSp9AUBJXcQCKHeRI88OSDNKEf+hnfTIZu1kGDU6CumhxIgbtUMnggIIL1aNZS1YQ8MlPxb6WhCs8HBJpikrHZGAf1kvKiHvkRgAhnNTVPr1HGUyOVxHF0ihlJW1cakAVs0lArGp8GmIcaLocb7jrYoHapqiBb4pAzAQfw8QiphcNPTUL4SaqnF3fWyoF+IujIxkpfged14e0UEjCd1DY1XXJp004e4esRBgBhD1DUBOpZXVoT1mkl8hvivi8CtzEejmauLvasrpqCoZQpaio2mKpPN9pMA+CnENDrEemgfor15yQo4BK+DPycAD/quJpm6XiCBSYeGGpdNY3PKc0qCmvWRQVSkMVHUfhnWJ5Y4WZ5D7sltGkb/y3lboUKPaJ7GdeeE2MXJfIHIphQiLFTl3OCXgzyUT03GhGBqud6Y/iwFBBpqfna+MehzVtH4lZHn7Pcn5fDoaogpoHUmZZDL6yF9YI7ezQtYhKUQCqF5hHKpOCzFDUN300TDyloOpYgH08dgdknQUXETNvIfKWQicrwct8Ao8cuBeUoBLAhcSta4BK75rMWEErx+DDdJmLHoPu4qP36nGIXruA6WFxH0ESGm1hEStAIUe2KuHENkMj9W+LyD0gwPKinSlNl/7PRpBN7zUg64tKejfx/lGFp6Eimk3mEUyDFc0q2KxiXhcEblrj4oM2wuQKFhjkM2rmng60buRPauDshTjJ/jhAQV/SDbgCR/lh9ZUm2MTYpWhvUPO/JrDIKaG7fvmlFSKhccimIVzYh9ThR0IrhHMrSMvF9D5dpo6WIGBiyRyAscBm6tDjwgupWBvwbIOPB3XSn6jOWswch5DEMQYTCzRQ+etXWTHERAPCKYOCycB5g12Sso03bwx5qwGYRq361e2UCNIi7D3MBSyrwFcrTJMumimR658nWGZWsy9FuwgBdDSNCv4U1/iTc4B2lZfhv6F3uNi4jzcWtoF4YLe7UuZ9szcWaGifQYmC1luG4uXswrCdcYwFLFJyxV4nqNYAvFjdIgnH6ro37YL06xZdUX8+gn/wD4vTtyL/4c4C0eLj34y+ApeAumD9NdeVRX3xGX/KC8W8aO56ylYQ5DHFN1uv2RTPSOnoEPUqwVILOJejy5ECi/nrrgF+PCSTp6NoRG6gDv3XhLxBgoAbJE4E6JL4aqAfUwj9RrfNqt89X/nHaOy2Y1k2d88JEYKLJ+iNfP/vVQ8A4YcW+98vXP0/FNVuv24EPti7xTQvWewHJyQtAZ1LhIb4TTA3UUZOQFyRxIScVraiSmsg9C9K6yqDQqvW6UmAC9HE8AE+VJgT9V8usmzpbhV/brG7eOe9HpEFxtTaz1H+cpjVdTQ+VBOj1nGCCGt+HR3KTaZSsG6FgesQuwK9KP8oybBnpZWhJdYQwTi1OP/jpdzBrDvJk81qm3ys2Z1SbQGSKonYDDcEI6hiDpDLRgPBDz7oqi1zUgI0a1l/Pu75YSeC9Qr9Sgdu8Ni2he+dYgsYYyFfC7ZW28SoM+kKezOtd/Het+N07UrWti8ArYO++8Kd3Qr99uLZrwKG7uHVJ34v+NM4cdE9lqqP7yhX453f0+CfeDxLvXs6hU2n71gEjWvBervv30K+WQJhQ0M6lbj10kmHgVSqRNCdvVcgQqCejHc+UIU2LQSRE0ijMyBqaZt744SYEy9U+VLiAWOMJcAjQPEroMbgVSUZGGpSxhyH2UTCYAFiLoYTC4sd/LLaBUlrAHCpr0S8LZhk5ngOWM70KT7Al8uz1IMzs8D4QTGOMAKsUEe2cgrupoKtGcITMv5FcDaig68ToeG911wR0v0TBIEFlsMIYrE0pkIwy6TpTY6sMh4J1IkEOcWmwwhyWGcYBgHgFqzcpUA8XuwU7BFIwEAPdAmg+WN8p64JpltYjG0xqSpr/R9Ln7Go8gcUX9HCDLzkMuEnUM9AkHUk8ukGTBJpmwQyjlfrk2uLqB4NP18dxr+po0mRX6+NmG75/+Tm0+1fT5NWBCuIa4I+hz8ZNnchNKNgApsdqRyX/MD6JsNIjrO1yc9cABibmD5TIAIxOJtpeD+fdR/su+GqquXR8OgHUSfILtAaaE7WXis+BCqows/XUFBxPCmXd8KiJ+CwRqCIpJMkI1GTc8u4JX0NzO+gzTrKPYIRwANUZwqR0E3lcmAImL5iAu/ZxmC6GxGdDL0PTEIlToI7A66CSxBkqCQaXB5Npm4kTfYGYaH7DkHboZwoIk34S+9zc17377msKhz+Ly76MA1VABE1tznVBe2TKS/1f0TQ5zCgcwCzx0CJrWKCWblVgPOQki4ZOdMRKBeSrR/OXKtAAvl6IQTrwXj2hwbgtU1oaUUHMOSH6YxMbFfSReuiaUA/mz9YLilBqRm9FritY5kjsg9OajSY8DugX6BPEnt1p6wJ2UthSOUiwO/ZSYuJOvjni7ANaCtAc8vuhXnl4lziSqIQkbt4bY3lhidVWQ4GDl53RqDgUk1kFHKhRJNCuEjSbQH1zcgOZo8xCmXk+Gxp8PJe/4ylZTNAv5G8Z2ZDBtz6RJFuB6U8Tkbgi0shQNWJeHjoR5WtpBfArtoInllJhjtBuHUKLF3BcMqOjW6NSWkrGdDvtIMlD04IoMNn4X7iTSnBjJVS6Kmijd5DYM3zHFNC4QRfeKvN/KjYojMsS/KitlMysQCkYNVQaCpV6bpSkqC2jH9ASdOmm0XHx2Nw2QruRsIVF9ou+l2VbxGir1sqVErELc+Mtmt2YiGyw0eclnkilkHvyoP8MORDZ0UNdws1XGWQAGm3RrNZ6qVgADtS+hmJgO/cts7iUyHoldjzgEOKhMbogD+xEYnFoPmhChjWPzGbwRBjzKOsNuhrJVII2atA+XhAx7CDx65Ur0W3Jv4ZLKOjLigEwQjng+34RZQEVLVUhfYFM18ZjbMv/IjdcYfCojbqwwjBq1wqC2aBQEIytUJU5LaPwX26SAl1THo1RvoxWbiF3FikmTySJex3SBj/6kdC+B98uwQQvaMGK5HrZQOJWmckSgbI9HcTNixjVU7Kie6vr0k8d6VBPG5rGjX1uohAgviLFIXc6H9ku4sjyFavGmSHWNn1tWxQa41AzjhPe5D6yhV2SPkWYoR2ECeQFhpKUau8J7wuBytZDzHNohUSWH3J9JJcSHx+lgwi8A10+8TXgKwp1ELoQ6ZOLd8lby2dR5s5ZANXtK2sHvMFAcO4l7gtmZp2hTTa9LfZFuJNY/Zk88xW7W2h5pnKtRnRr2jz1vyScRlNMVfqflGpAKdKjKNYZTR2cO+GeMXeqwRAf7B96DtNmag5lm/OSAUMGousF1Hs52lbggwqxQKLF5JHIgPtJJeiECXwmBKCN4zaLONohB20vRZhNYkEQjSODVWxOMJ6DGENL4w22FMdNIOaL3CCLbtDQRdSzAx7D5CmwgMuRYr6FTGQqGmTpxO8a34yjrqrxvN9lq/CbUZ+ymWvJc8ruQIXDDn9thXbrXpOhc0j6mpdlDKlYW2mGVNDmKy38oMKnKmIRQm7JUzJYYTpOM7VwtOIJzdrOTd+w3EmXdqqRSUMZgJu0nKYRi6R9FaVCIQnwjEpc6wYswxFiZwECdsyXUstaWAqTF0MSQpwxFbF6xVdQP1b1q55Scs2gx4AR3L/BhWg7xy/AP8df2zcKk37B4jRNZhYUikfSghiawn/8+vRp1vDniGeHVUVPjFwmoQAPqOAPYHafGEw15s1RvRMJRIAYNGrUGLidkCYeI9iWt81DJ585CDtO2RAmBgaHgv7OinXjiUWcTKq11RaHE2C4/u6p6x6duOW5UZpwRvm8DMPhm2WVcjdqf/eXX8I/X2r+EzTZaHvr9V01qIbN7l20+XzGK+EQzx4Xm2O0XDk2C0U/6D+p0uNJMwK6xyVi5G5BjHuwh0pCahLPs5gAYrsH7ktWBBMBreHvMMxvaAfh2QOScwzZYyILgmLrDcEl4rAe71lnk+MimnWxZDJnQOblRP8kYhR2nnaJS7nEX1zELHCxAaGJwYUGE2O3+Mhi+KQHPfFxO4KWPyN06ix4XgBxbY7wpAHiGkfE1YNUErc81rbNMS0LpqukgwvoEuamQ3TiMYdcKhdb3wlPBxNr7XwlvhRgkZ0vgEGCmliioo2W5YE85cwxVgViBKaSitwGE0FISgxhjqFQIJHzD+hePN8B+scxqomlyCr50vk/GiyInVzoVB29AiJRoR+dvkjd572QLb3wBrAn0b0g8wrTZ4nP1/46rgv8rOhF1NcxYWVANlw/BB4pmGlFUMm9EsgbyK7gA8Rl0fFCIabiIF8fvOJiBROhrL0JTWzcFYNUAMCyHGKYZJblQgOmiHMEJBAYQOIFOZknNfTw/QOZm9Ql/uMV7isSDRE/Oou8uIWZ3SLDO2ioyOvw10kBDZgZzOqnUG1XZKL7YjG0NRkwFxO5SC7rbYVfFnl7ABNoK1iA5zK73dgXFGjXX7LbbcOAF4bpC1Q5zZTN0ImK0bawhDcudEUDOY4EzhZKhmWf+n6sZ5U9MqxKDlrx/a+SDC2T1MwFXqeI0TUFXhqUEwXe45U20xGR/M3wiRB4XeSOQAIvDgj3rI/MvyRgmcdsuogHoqOgWJvoyPaa2RM7+USiRzHWi0CStoYxBChon9DDiNPGNnuRUoNuCi694h0Z6Xdor5Kjxvhfx3cxhAuzV6GYGtGwMAmFfy2VS7QJiyFoHKAPj09DUKaoFDsK3M//hugc1kRjE36puhQTPoL+ajeikCgGKcpTxMcFL8w7Z6AAyF9R0qAL45Y8+pp35FpiokcvfkdkEPAYsQcKUQHFCKWQ+3BP9zc5NUbLHOheb4k9DhdNj6EMyNzH2PKQbH61pgm3xWyA+Ea6Lc+ztoif8V6rTTVDFqkEvGRT3R5JT1FUcWn2ik45qk0kKLIksjBzIVRemtxizqV5IooimR4oVwVMkSWRRSRRw/MLzHwUIh8D5qN445J8FsXR+Sz0VxaYGSveWGBmrCC3I5HpwpK8Yo7R98tnryiyZq+oNQ7KQ9FCUS1pKGDh8rsikcCBZyXx5+gOM4WD3cddkrjHMPd4dPkw4Zld5G/4o3boMVBlPaDa0rgSzdM+KL15tqTrjVZEylEZPSxs0QkhyotrJYSwe3g+KoEFds+KBFsC0XhTCi5qExEQuMmdPoMYHHRgjDGs6YNGe5iIReKftRm6p7D0otROCYDsNK1Cl3MJ3DfiAzCVnj4tR1duoFBDEjucSA55C2izRRklRiizFoWPCYLnMw2Dhq+xDBxwLYiDlEjayd3KveSjZY+eSjuPCHMiE+FWMD99xUlNkC8Z6X/B+Kj3DCaAfmF2YSa0kgxnVG2e+SpOdfrfFks5ISotuIBArJNJkmy3KU4PRrbZkDz09jn4q7pEtg2YyXdolSd4KUFfnE4RAxkIf6OEv5yIo7ZTLuogKVAYX5QUkbKTQZCoI0CFgnMSSVcIWVQw6kYqpkQuUynchEWFsKUg/VTroD2G7H52rtjY+6StI4tbqZoSCqQYFjcHZeqk3KiWZgm9eBPIE+3mq6khtE7yV/1WvMF9f3haBw35UK1UTQ5h1mmskKQmcn8ihCowfbuabN0KjtxWa0PxNl5NBuyk6BVMPZpEwq+CbmqH0rmqvTed329PB3yvA0QXvpPfQa7Ax2T+6iCvh2t0Mt+azlOdlKdTGDS53extwqEbdOEeR9I6E7jVhYF6PEcCpnEkLLXAlb8JgElEuSmZ1EG9aDlGxaJ2K3as3qOdBtoHBFAlR8yBovxjLaSmlYkKmJfbeZlFoLpyVHhZTbHYstW6ZSTXihWSYtkKTImsFxXAoa9Pz+Gd1Z+QundZ0PbIY1N7dEU50pXjX0eEL0WtN3QCZelW0LOwgahver9jqth0/EwCwD5JbIogCvAtSovJVnTHDOFTUwI8O+1/7AUOJVAPum3n/ZE9RMPqoEKGYkAdVVgP0UkVZkShFAYeImTUSfg0kQVyJUDBHRAxL4e2yRT/euGlKkggHyrVBaC5MFidw19NUe2I4J0vS4JchNsu4TpAXYHWvDaMpKU1T19EFzU11hCuFEq32zqH4nubKSHEE241grvl/O54a35bzG8rW1+K5hirsx3vlY4K4fcMC35zvFYIsxEnUyLuzgLbvtBCHNU608dMrLnKrPFxpAZ9n88advwH1j3+ZKvpK54cfy2HNJ81Hi2BUbst4A2xZW3n88oBzKFuqXbcWg3RrHY1oKwwP5xWBSyp2ODd6tbBlBLyEeKLTxHswENI6YCJE5SJT2DocqjJ2RzOp0skWmY8m7EEIgMtbJQPMFIOpJ81Ln7/NN67OsjLRbKkZfh8Jod+MT3DiTe2QDrIIdyV9pHQK+XrSg76SJnxXnYS4ynZvoXxCKD5kZ/qmaYfsGo3IO2j+JUVpjbksvqLgcqR4rUmP0aMdqgxnK0iPqQCvebU/pJV6owAOaUkmNqZfIIS1FSrg7lstEWtqSllltVhQNP6eVwNKD6SswdKEnE65YdPoFzxKGajVXGtUL5JCRa7i0To0XuX9olQ7OACOK6hojaGaJTgeUOi0BUpal9DJFSI0HCnuV0fAFVOGPGQFboEzr+olfIMX6WUdmGtMPeiF5aDbx+g0QNkYfQoI1sG4l1EcwK4gEhg5hXMItci9PVw64mkPzgids0al9NwqkCJztRzi11mz7nDq7HlAvw8yicQM1dxiytFHtyJchQq8LgMmDXexsHjbcgCssKc3ohLgzMNswoGPRbjiIisiona9cR4GzedbkBD5s7QXhImVS+Jgyhdekk0AbDij15sgsarV5Apnn7EpopXX8+frbc8U6VmytqVUkf8h99tx7vteKfv5fX3Wts4xJ8dMp8RXZeEaJuvSxMwV7ZtXRBGUBqIRWNIL2AhEtk/YtbxXOSUXMSDfjhoZi3jgUVuvPGVWV2o4ky4iRA5MTdipxqNJU5KOUKbmB5yFzDcS4Tlj9tq0fDFQ7WAHmBs/xTiPvHmhrT5KVjP4pAYq/HWA+SCrQuhXViNL6FNRcNIhg8iy9iDxsiyEHpze2G54VYJ+RMwineisBSKuTCWQCgYP5SHbcRTuEEM3+8XKfHFfj/XGXgO+ARAOTLGJZFmnsBBTwZK8lpWE3nifDXZ2KWWlcim9WUQEsPbQMxCvYDEx7wcHm2MqI20HHM4wmxaXDjiVE9kIz9id5DTgv4S2qRHrcJpZO+3rqJ40tVbCOaANkJLstB4T4R48NBwit4RNSm+stYbRKg8FLgYNzQNk7Xj32FpJUFPtJujkyJVyB4FaiBuvXswUyuZ/0ME98tgDWqOyb24Jkf2QHESyBwivdwhVU3gNROJoCYKUdvYDEAQCgL0rIIHZ5A3F5FBi70Gyd1aI46HssqAntADU3j7N4iYSWBbcZR27Dcft9FUfI3JLSzw4jtYND6vbusZ9KUFYi3rCJkiKnsoLK81hGVBfTEpPxpZYtHZxLAd8TUKSkyscbJKt/Ublx1+dt5rn5BwLLwWYnG8sdxeYxpskEUCBrv85dT9OFqY6P8RY6XecbRGuNcvaS/AJNB3H5N4beSxCGibI10W+XmGfHxOnMGFTUA5dSag5BNn3eju3rRSdOn6CWZTvkhTPrwxm8KNMo8a66mwOY354R54GFxHhlUjU2pvw8/ZOLXKmtA+YBcpTxmm2hPGXwv3UDn9QxrZ1tyHMbRKC8GzuEB5yeQfrVWiV4mPJ5ihqSazdZzqQ60ylgQwewhw0zB3ByjuLVqrpD0K0QT5kpqvetGbUbzqtOQ2xL3IOWRq8GCKXa/Ij8vtxzzM1wIHtBZGLz7u3Ybm9e3c2g1tC7t3CSzCVWh7cVtsu2QWqPVK0Bt5Keg2m0WiRcKbV3WX4MamR0R300zQpmmMzlOSxCk8fJE0kDgDBCTb+Qydw0Rqc7s7jkYeZ+ocvUR6FFztUnRs2BNeu5NM6K5Ihv9im2lHJ2VeQW5upKITLhgS76owDhVw45A96KZ4czctLcq1Ze7yYGIW0pkU7t/F017GRCqoHrLP8hxfmLqHx4HbsXHixGhrwwgbzDB4Pecw/FQbiom3Jn2gRGJcIuFnkAS9PD+4k/N67obv43DFFJPoUBEr9s3iuIMqrfLe6I2mOnjaJrvwrrABWcaFqYhH1HdyjIVx+XGeoAJxFJcaSwvITdooBjzFYMCT3djosdOM2KPPo4gh3wnMGjbHlRPBWJFEMVYnxwroe0940cfPmMMc7xRw+k+j9Yix+fmWvDsSVAWs0ND2ykz+k2K6m6eAfBoPjHM4/TmqlXbfvQv//KWFQOI36u8NGxYKBeonwvPTt2Ci8TfgOSYeH3ftEaifBKoKefjFWt38k+kEKS4OwOgQHcTqIX9ul9XI5UeHBYSoRXSN2ARp2upapVo0xToJ7nY1RoS1ySFVGPlK1boiVbbdSCWF+MXXCnTlEpIXrKvWBYVIRBRHS9pylDYl07rx4adNI5gSCaQRu13uKCMYaple+CR53JP3i1qXsMRwqjHoWbKKwS5yaalapwwNZdEI4uANgFaMniwCpkHF3LQTiIcnqPBjVxSRBVjGkstaCuuSnbuCB5xEyyiWSoBTDV443rt1DYatmJdD0yy+vsOiTlOpUwIv1VXrrBKPfgDNqi63J4h4ke8Bf3jqehDgQjBZZYG6OFvbdxvAQbN8NN1OsCRjv9zlUJCzZDWeb/WX4mY9ZkcKoQZqp1Oc1JR3g6m8aYC0aenAAFu4fZDN/+uPwAmtzCI8W7K0B5KxGTy8Rk2FaUoue5eSnflpofvJkM19ZkgAEQIXz9twJ6FaBhdx0IGAaMr6vkYAewTdQK+g7SPKfGhXbdwzKKhwomSxX18AiCJaF+RcUoQ5BXi2PBAY8UNr+gIdL7YZkt9aSUbnNCRbxl6FdSvAblrp0R8NLRmYHcCpzwnkiOh9hbvdYjoZ1c5jvooC3ImdqxTkuQcqjmqjLEJu0j1R/wqpMSGqZGializSLtCCKC2RrRflqMY9P77F7nnL64whByDZiELIMjYVgo4Ia8VzLvJA2bblB2OEgcXDJVWdSy+CqTnF+HyR8ZH/snCoMvX3CB5409ARnoeZBeIxdQIQqwRgAXjUIPrBoO0X6V3tsJc6OJnoWKUmkepSB90d/LWVHpbFpfy6KuuTVroKkLNOCfH/BJ1s0Yn4Yzpi1w2g/lCXEAxELZGhjHzygDOirqPzbRfTP9htdsnPyDhEoX3QIjJxiqtJsJSjDwWKhjQkQOC6OeZ4IhCBTo1Ns0xkipq8ovtTLUpmPzXLcW0pTyQWwH1dPMMwyJUSne9MiFmgb9ej2FCajmB8TiANiCr6KHoC6WpaoL7uCjTAzsHfhtCjhkEVR9YQ2lBVJ6pi6Wo9ipWFe5h5n6pSQGEgoNYHoDQActwQORLpZAgiQ0NOXqGmWAlW2Koug8ifh/kYhQdKQCRdSw6VBZMtvkcwXnxaGrG3r7LUgJZqFUIZTD9OBk9almiAWfViMFCymoA982NGNoYb1XhbSgGvCfAInvMa3JIJyjkCPRHTjcAsUh5BwMpENR2wJY7ardWk2RozWmNmawLLxEw66WjPYKLALwBwXdKgQcmHZpOQGES3XZce/Wt3ect4nmgw0UenXiVg2/Fk5OMb7rEo9jAin4DJjNsZ0rFKuloff+obkdcN8KcBooAIYEi/ASQ94SJvnFwpLEAeLqdiqiNgiCDvSGQnU7hZwc7NZUk8hQ3jmgZ6BFPWYNYbnV7gDdygdEcOC+bOJ9zFxyli2OAyUYRvJuDBaGhrUykulKgLx6UVwERw0uri0nNZVoaoiZ1IyCFDTjCRvCvVBISb3CPqMLtkXMBIL2PVxBzomsU7Dw0uOEsJ1ngIyyFnaWIDTsy4yzLV3AxCGIrOHnVWrArWwTSBVpyn9hPUJPpGooFDl/lQQhoZhQXdMqyK1hHzj6GNTTHlsMssxzqWr5uJufEk2Tk0bwqPJo7vLeQj1PiFFu2pjPGKTKAF3JNIJi9SOeJgV3TEEjKLWjWyUooX1YuScvwfieAixvPVy6MpbtVB+SEtobEqJdLnyoBgc6U84adIlmikEvKId6H5ag8FVHnRO12hS5/qWsW3xSmTICknEm1tI6el+JFYgimmxXLm8OcG0a7gXzYE6vSs1aYV2l8BYhqdciYGiGqH2HZx857wTph7Yn4jD0881k4gUmVroVQqeDRvC6XaQ0FfAKJ6mHO2yAEcNwdmGnA2Bu1PSdxbu6gr6G6Usrwu7dtGLIM2PGWYMnMGU6AzXhB7fbhwgRdg8vhkCpVL5Q7C7loessE0NS0UTBPwpXQqaULQd6spHNgkSBtRTQj6enz/08Wjy3mWJ473qpDPee4wTk+EObhWBH6ssc5B/O9FBxeMx0ThIGpQunHkoqSTmVZbfIfASI473FMYGJpEmZR95HlnJCilzMKqOw8xzM9xj/u04xJpoLrXBRriJAiX8AaihlfU4FE8PtXbE9M0JBOG4jYkDcMXhalINxqqDUsxK5b49jqUmUpDJupcLu7UVYZnZ4EyAs17opPlIkIH46OXA3QPQ6M4DuApqogpMBcS5lmnAF6YJSBsfK3EAA2jiSV5xw20Ua2H90lqEuZETcO0AlyjwygkqlsaorqpgHvYbgz9xsBcU8RUEq2F6BWYgmiQQn6ctPx4B9Hu4MQYKeyQKaDSUnNx8Usgk2glFVtJJYRJBpbkt4AxkseAvw0CPm42pAGI0jm7Rxcc0OzI61qBvor8V9ASdQfWCjmAu5B4xESyaGBPY9R4HIPoqUu4iLuNSv/QSVg9dZDhYbQYfLkeong9NY5TyjQ1NgT4KeizcOLnOxOmMCAhzRaxxGKd2JBkGttusZ53bA4Ux9HIFENmZMzoa1dF1BDJ5fEzuA+jg5ysxPq3c60h6ESJ3Yn0zS7IB+ADHWRC0nn3h+go1Fka9JRoogghhH/jyT6MjvxOsRGVAAAAWIi7ROvHyXcDuQ9UJlMvSYyJUJnfJZuMPY6mqg7QorqUPMSJcXYpRHvVusTqDCk5JHJV+FBUMGzvBL8kmFK7P4wt08EVlLClDpC5FNWO4ZM+mULYsTm1jqG0YagUT8Fr3G7iIjT/DIIDtGmdPGlS8AfEbZzoZLFvbfkoWitjI8Ye0+heXRhI9VKZofaalSgUodaMBVNVx9Bg3TTcMavrk9EDGr2rdB5xqmIpDQ83lYQBnaKvU0vwLL5SzP6aCgokj9JTge3huZKpccADPUdkG2fKtgLjMCNLYmhrzC2sFyfmC7TYrXlCmHXWoCeVoXmLCyFHNSO4MyayI4QVYmpXqBXo6bFsIZWWcsqH8UEUThVzSRHG63tKS7rbm/7acKnPllVG+6fcUzgNekfbOWiUjhF+CBRZaQaa0/aqCC7hcfpWEPCcOuRi7aYAA3i9rESERMr0RNwIa5MQoSOpbDyVNrutUClQMJmjmSBEjbL9AkFy8BS/fFMwIkw4/7sw4TSFCSdavyn5FIjWQXsOz99hN9w5HMbptQ7yonRGbQFY4+URHfAwY5c1k3DEnB9jSd0xjKwMMWjSi8FcY9xkKLoW9HKI0qlvvmgMsuGuJqUXMdLQceLLs/SIcfBcdHieCQqbeBkH+g1Qfcsh0hhu5RDFpZj4y8e9iKD92NISYBFxpSXBGEILD6BFLOafob0vmXMFDJ6IByxPoBknO04QHe9ikRPElJI5mXMCTBthBrqTbx7fXTEqCG+W2k5KSMdRO0rAqPEEWsQYpm0GoXAhw0WHCMVxjPWAKAFvUGYqD81FIMbLqX+FGjlkaL8SYzMdGLh4LRc6CoxklLZoASrOI1L+iW7StKATFAYZr+NBVVFJE6LyllDyRzKHK6TPBWNRcZRASyezDMgaecBAuXHGmgwDI9PKMEu6eNSnAtYvTw+ZCKwf5FmgyCi+e6x7k3VIiUsoNZUPbKkOtlRXrVsaIm9oyxGrJ4SpAw08qp8WLTnZwMxjfpK6l3wbWE9KaWmwbilIs/VK0ejMNcp4oKp1yUnSjMSLxQQnJru3BIDFAQt3R4WKoeGYUjsJK5GQB8T2mcEt0BfHwRNm2SnMBJO5i1QhMZ5ZLofbVJfMs+eKHKZLijhlju9bKobdjbLv5WHee5eu5CHXdHJfJ9WZx3UVvXpOHPB5YZQTZyEhN4oBruMWTNuDmz3H5+DmOTlGY0QOf6+DfGgzqrxOPL7Mgy4n6PZA37dhmhaU/ikKr4N8mCoq5I3ixbqqC56m8OSb6LDjwdMrHFy5o7BckTxX9fC8uB49dMGXI+I7PejgQC573Jqgh56XeZBOSOGZhbFy1MY2hkOJzHzxlgg6ckuUuVKvYPICFK647gvrFdkrbg2kkzsh3ODjRBGzqJB+mUTiA3XSxV3jAPB2VBpwlOLtYB0sqhsRR6kfTjIzOXOIpXC2QZGhSlRmCQMOuO9uR0UJ857m5dCQeaik1anLcrq7cCkTDsTWXHnc+Kiz6yOWGAQckpxUbsQwn5HJhOKqrWoNkCpUa2jE6/hH6piXoWDqv2gtqWWl5L+GskpKKRkeMZonnkLQSEqnhurBEixD3+SEENqkUtW4EG4TIrlksGqImibxWFc3N0lzpq3ymEsRCcaFI0KXoLM3B6bb6iiM+xQlalwZ6T/JaC01tniT8ZyAZJF6SJdvEAexyBzfVPyiAw0EFKBPsVfUAaR5MOn6lPEEPuiQTewuYAYuWhvrUHiFwSWUWY1wuCFJgVyYHN5tRG+DCmUem1Miy86IJ13bSIyBos/ifo7C9TGD+6Oq9AMrkyf+wXVHV0m4TPnmpM1IGyDlGAlPSMnmuw6I88SXXZQL2swCZB5HYUhMbgSSW6giPEbdmg4ZKdNmTw6P/DVzeKvkMQEExP+xGIUrRzxRZfNb+ARoB/ewpGN+RBXJv0O81jYConWyIhU4uOuMrMdwvxLaTjFy43OHGBv59dMWMflKU2ZjI/qbH30S6SvGbxpBcGJmt0MjCDW9EAvGp63jDpwxplN5qbGdhp7gYm8Fw/bMCkN5zghcaML7JUZVut9KZ0VXa6XC1cut28UYYlAlV0QcbZWogCctRkBKjtgxSBZdPGzBzjeje3MTF/klAPOXhH8SQqgBb72eZ7kkSYWXOYqGMgeQBw16tq4yI9QoHs5LHkmv8Kgpg0zJPBuFqOF/3njFCMByUMjV5tohV1T5Oe5EajmkRPZU2ZRYkmUw4axIRSEO8lDyRWQNl145ObVjfjWU11xce3WTI2Yk4hub4FHfQdqmBT7mJw8/aDmWvI8ox4qixhJziOdJWWgnuQSkGOH5YSSLRMRPMK1TQKD7YSwluZehlMC7osZRxEFnHskSb908lWFW48kfBQkI5/xevlfp43Yv0wuSsijG81A9NzfsU/i+DwNASTSKR7cJkeKcfkHUibe4q0RttrtzoH6M6Bf13Cdh9n4vDzPAibLxYFCJO2dLdIRWL75NoIhZ0KfQPAQ9uWhwVT10bA/5weHI0cQ+JYeWGWb9iRO200JKEANTFGsAPk6VcdvIjn5IyP4I9LHRwBdDwW9cBv5Um87jyVP9hmGfe0Crwpd6Cs+JYqaFBZHgeswcCXyFx78quCHpcQGNmD69iF+UiIvtJTPg4oAsW8zUbS15tUn8irvBZ+QzoAN8bahsHcK2ROLECuM6aBdOHT9Y/SLNh9owIxHWuTAeVc6JxolwaAUmHzQVwFLQPw0vkIuaai8JhcqMnBwg6IuklHrLHFJ0sEu8BzoODMbjf1Lkj5GQL7UUGTS2Gg95DlVMtZLSUSmaQS/inb+jcmG6uANGSM69c7CYx5H4xUHF/BsURPfEXOthxR4rzbZ59ltIT1trqkwzaBhT4POIPDyPFQ9YL4OWMY0R42kjxHA+IGICpMe/XFAvyccPhDlejS/wHCMEAnh2mp4FJN3F9/vE7PCwac6YD4knIMEZDyU68tzI+6mK9A1SVMyo5HkqKpmPJQOoBVMMliQhU5Em6EUYjwh3pI1tpy+bSchs+lU82R6dvIQqgoMOhQMO6xWZObzkxE1jw9oEdw6WJTx3pY+Cpb2RRKeYipPnOkUZRUUTcQvUo0GN4hxedYn9Yhe9Sa6UIGKUchShPJHYCJ9vh2W+X6b5tpnzbcnaqTo86/G4eiMNOjNPodbFEcY4sXpLI1YYNFC9k5HhG0+5dJI3DZ2VnIleuHhMCZB6eJqCiX7p5F8X5V/0UwRGpxx+niXMVpGLIj5xqhGBdH6mpEKV+FIXEFuIL6ShV70LzxAzdevfJRm3qnQFY1LTMDOVrowmyE+COZs2muYL1hAJhZwdSeLsGO5/dyPJ8Q6gC5SUyYWikY02dzlJcuERmJJeJPfmYlORzM9lmcZPXytAdKXdTJ3xlFg8FxSdPU2iXC76SDLuBW5fRx5xPHWW7QaRF4ofqUNvUGXyiVoXsuC2cTwB7TmL5LuelxJcKTB0jyXx5KVrFkQzlR95bujOdj20wUPxjGh84Nu51LcMOYXy84HYQ0725BJWvcNDKby5TQG0q1za9+UegvoaaAmzO+D2MLaKmTzI0R1/vKCWXdjh4YlJeVJu6AMGcQbrYj8yZBBBg2R0x3DJeqoXnRqooym1/MrSo/zK0mmTPQ0dZoiMMhD2JNLw00OBdJ5qSwL9xOoObqONhBw1HaGaRnuiaYalP9GI2xXbbnXU2LxAfbJVAzQaIFUpRhG1IY4YL1Q6pDsQACwKQl8awd/G8PcKQoIm8LcpumAgJ01XVfzJoPPBhck90EzNUNNLAs1pqHWj/Mda8M2zlpYnwA1T1KRAK5KQWqo+LkoJ/QX7WNQ4L0dtiduLMAmfxGBZY8MlA8vb5uUEW0MFcj467CVml1EaTIdeMLWp4ejRpjSYwU316Wqb0kCbiEehE3ONCweMlBzUJ0l9Uhthzu/QItqOUTMA+PCsCcDTeFYaEsoU4VsalLaiqvBSleWlesYtHu+SViv3iMXpqY3aIgTQSAHRDQDSiqawFQwLprAln0JConiORIbrTAu1Nd9CYpHBY3JZNOzRR0vV5mWBDDIw8oPc0tBHgw/SyOkOHS0JpnN9ATOap0K3vfz9VcE2ahvaZfMYffZZEqzj/lHc5VAtQHaUiMrbArpRQjizivpXKhyiuWoM83gFpXFswI0MCLyG5G3TogSQC0uFcSDQGnEzKdASN9EwFTtJPkytDx1x9k5T03KCrQQCteYIksZf3eDh22rpOCtGChgEieF5RwI+IGArQkAOLrUZWgsIM9IJYpbsMVKwHj9oznkT+ZzQLrMAUT01jUcdwEU/HuefDHSWWufGSaY2I8abQ3t5l2k+usGUKJiLjTyeBN3Q3JtgqoZAEwAV/FwBiA+FTdUgEdNGVNZIDWJZEJYPlDU24kOS0XiaTGE2aC00kt5YspqT17Gd9gdQqw4yoQjTBh/XpVFjQJNHIyR/LfmBGpuRtFKaVyLFSBmJevA0RE34UT3CXIW6cSp5iwPSJxKxxBXZirIY8Tkiz8E2TwczamURyniJ+97wLEJOD1/GafraV6ahZ2yq6swLOtXUqGRCGIplSSbUooSQktPOtbsezgF8baNmlKjpmIhZlBhzazgS4DwU0USIrdFGvUQUzgVkKnWQEwGlIONdK2IYQR/tXSqRDcYUtY7IFUQwg/FSrFMKjxcm5tSEoEcbJrC+COGbEOm1UrBUckIilsEJp4VfmKSGs43I1jV+johrChFXzkGIxBpsBIdnrm0xPC9RJq+Re9RnBPcj1tSBFiVagQLt+OImymT1h0B61Brhg+RcDgCqEZSaoU8pNN2a0KQlbW80sZoK29DhC3XouAkglMQ0sAqSjjRBBQ36YUdVEPka0hGCls+AFiAIQMIH8GxFyy+dw4yvQInr3Qg39CZAwOGvdIkjCVoNihqjDJVCv0i02yLNbgNog/9nhIB2iZMKFOuBIU10WqlW2m5s6bbGEydak1NKIFFthjWaEeRxDVoAGCX9Z3jKZBn33Y0tF8WQ8+nwBsU4jdE8y8RlOVrXkn9TErknFS4a0n6Zi6eboYPGeb4dI8IR40k57iqcF2GmCExM48Sly0+vwNlHmi/O4KIjuyhRoyVQOLo7DLvDojBNHNpnHk/q4oYoiccwGi7vq3guF2wEbU9rKa+UyLfGo2C+lymRlLOwFphkDia0WPJTqnU5Zx1GCpClzkYYodrFprwRHBmxSIr+i/VlOalYFoHoCheOCZxuDk5xDgLa5yIBo85ocPIEmJEumHmLgZ0CcnM3mX/8uAE8LiSqMQbw3Bx4HpEpk2fFpNYxgMpmhGWYOlspHzcX1vEjiPZrKVkXnxcjMZmIx47BTLS76HJ2R8lTeMm5CDIIkRnyoZr5RXhSJvN/whXWma8UYSZH/QvGT6VUeL3lMxcY50d3K+wor8ZbHZMIz+LpfuSn+RPqnD5uvH7opU9fsk/EzaDlvAQj9V+JXP41Ay49qKJ3kGeJx/TxDnJR9O1e7CI6AXaQf+CXemEHuRIvSej4C68wU0E1XQQp/BkPdTnO7zF3GNyd49XE3ayiBfylC5ZKdh46regLjNIiujCaFO/O4aWirop7K0XcOkY91qcIKOpx441RIFDixqcFcVsAg61kvTfa1JRcxH0eIYVQXoMj7yAfFiNWOsi7IoOnqeLNoR7Uiec9u/x/gG6nMaKfT14Fvhl06KBB6Yk4O/Dr6ZMGs6xMDtomQx+U8XRQly6NV20TdGli0M7dbzlIeTwCqoY8t7U42tAAMKOcTID001T7A+M78M/xzD0y7kxQViWvhw5zIhOHMgFDpjCyK0hp3mwEA5vXi2sV+rud+uvsyw9vNo7RVFQbUAT4J4iCppI7Yby4GE/GTei9d7Luh4cwJt0+WXeNRwhPwO/gEOXJum180DYB28F7abIu17qXzPucywCAKNU/jTroiBq3Yu7I4LjFqTZoLzVGzr0c0GSdy3HPhh7mSIsJFMbpi06cIQyLEl8NEHwO4jW66fCMj6orP+gaz3ujuiaIjuCJ0pR9GaUWl4cfIubluaZcKtnV0IrvgjtchtDVgwLXoD80AzAf+LWtNBt00DU6dLn/vwJvtIRVT18gYE3nHE4ZD8BBfoB2Bb47BZQbrdgApSSqp2AWGtpa5rUpPgf+9gna0+jEeTwpE3fYAnbyl4B2U8ifBYl/EFhBTx+tOyIxghfdUA8tXXz+ADgABH4UdxLgBH1TeLDgxxXumm5H/1g7HqRKhqpIPReV4r4m9Ru3z3Ef3RuDoQG4gsKFN9DWVCISkXHj+fRygDu5Pwo/JbgIQzz1hpTCq6amxnkDT643maah6G8tR/fTBABWka90ZUN6ghOQjxwFCFkcPYEpsOfrcZMR6hNU+wQiQPkUQZScgzMyAXe8PUSYczmKifOvoibIznmDOHqXjvfCvZ1U5EWTc+Hfhj3T8kl3cxkzZ0yRQ7X1IyEFZgq3GbnhnK7tAYWy8Zjzi4dxY5K2+jgU9E2hb/dMw7BufgaTBF/heYeIQrgm8PPSgU54TDqhOsfzyfoncmEX6MsQfeF7EfS1I3raI+gbdS+Z99HoS+4JGCCA7Clq4H0ClMUO0cFOM0jDRFucAw0FHGddeEHAEAmVSM6ymYQR2kIAuhCXPfz4PS903RWFyy4Dl6NokddNL0TjqInLLgsug/AZrIXzHJeZicsOjsuY/DJCtAEP+vB+WImUQmtT9/fx1SZ0FnJjIUIUGqIadJFTTZ4UVDFJqEKTaDIPLlUIEkYpx/DSIL6w4ngviZ/iGQF9eS8PGb1GVsR4Ny0dq81+KW0k74ESadgiIvXgzYbwmufF/5/yktciL/2rtASL2BaweUSUIALmIwwDpMyCqi036BmPsfa0E6W37SCvxdfNgV/AFoKcmeJ9Nd2jLw4Szb48c05fnyTOsLQ2oLNWjHfANt4nSEIEdhhZqJPIJoLNyQnIzs3OdpqhHLxRiFC7+C6kIW8CjhX29NlRvuZtEliCtF0J8zGen37JcsmMxldvDqZvdeAE4s7e35wa2msP0jpEhxgi0hLlBh++Lr6uoIe15HVSWCiQLWDjRos2sxI/wJQPpCeSfFjfPBdlT1Ja8BB1R1/a+3aqjlxz+oO2HJoXoMG80b4Ucc+8dNipTQjc1Aj2EZccFSIbz+WldKi6Qi4ihb18diCORHGdlHrGS/Z+eC57uPQo5miCIVzDghaDARGBNxgwJX2inoXoVqjwH/hIPx8dj4GkCrOWcmwwIYlwBFpC11w7ypDP4Q0tJSQzdGfKpP+EIiozUISOiHUBUGUTNdB32nh5L1+b4sTiftQb1VAIBJ7ivphQH1SL6mAoCLz7y7lY/UOEOCzAJ/8/pj2ouKUutAY1SmMAPI9WF2z/VV1QTVUB8zworZhXR0lRFcuT8ZUPHArwlH/YZnzYjvsRBsXEufeodpM6Epty5PxTTyyUkxk9wUMEeU8kLlCZM4wHPFlmVmW0O4ZLwm5gTbR2w/kqfKYn37/mmIPGUTFCZL7/iybxW0GVgJCTGwB3c+R8hY/vsrOCwDD4gB3K7aLcbpZTpHdOEGQoO9FqB9cWZEONs4DWTsuKX1M+bOJ2iqDbnB9GXj8YeX275fXt0a/jVQ4iBKOG8MwWG6l5/JQnBUQSkclM0Wso9ZuDXISRv0YpHEHWsx5/34tHz1M3TJUSVB9XROGTCX4966FoyVUMBUUOdPxBUcXN1RUurDh6EmF3XF5KkXgq+yQeZY9WB7jzR+6I+nHxCjeouaBiVmX8xFQSVGz8FAY6nJlMLkYn0vHMF0Nmo3cJxgYGMJ/Ex7lVjNOG49xqjNOt+/Uk1Y35sR0903LEOz14Whp3BzmFf8RvEi/0u6OmUwgaSaIAd7UVjnG8DJNQoceK6hRsDidOnzaeT6ldECDZoibaxfzZSZe3aIqKQUa59m/HOAjQDrieCLhv6okKP6WHlgGmDuaaoWLo7kpEa0T+05CED7uphdj/qxaCw7VoISyihTBDC7FHayGKh38+nbJUIwQjU4aCZURXYujkwpVg3n+iJ6QLbxULw4Yux7IxKByiV+Gp8zBjJSotCldaFEo8z/chgzYhvtuJR4EewvMgUC3cwCelJEjev4xQjburWD/nFV+ljJL/QOE9nMK7LBQeu8/pJZkLOlpoTB9OY3Sd0iuQM0efNFi0jf4DY/AY5NjF053Kc7BqR8roA3dF/A6zwaODZwde/I9s1uCkULlxDvF2RXdyXsiz7NzAgWJDuYnycxnITB3PDTo4a3SY6OwwyJFOetk/ojPOuB1UW47O8EELOttNdLZ7OFf2RtMkzoxdIFwJdHaY6Oy4PDqTCh1BZ/s/orPdgs6OS9DZxvHYhg7vfN1bMNr+TxjNBYtaGG3DU7OEhiSGhgNFgdFxOaS2R5DaUMYdPUkntiK1/fJIzSWY6C96xYdxGQnbmDAp8TWGyJHCV4KXr2OXhx9VpKDkauevUKldjAA+QKSaz4+Xz5bLE9HblFp6G+mSdq5empKRFd3tEenDNL7xLiiXKDoyZQo0eARhazomEo/iErV5BHrokP3PaWEPHmIPHmQPrkvYg4ezB9c/sQdXxLZ1GQ4hDhckLzIX16UNldhVWyWmdKRc2xZP8FbUZuSjaKSd54vO9v8cDzF8znFeGV90jKOLZCw6m7nobP910aF/qWXRyZFFJxuLznbJomOch7BLeYidb93iQpP5QmN8oTmhPWOhERKlqMwYi5BQyPnw8qtMJglVNteZjWtZsM7kyDqTjXXmoHNGRGoiQhTLB73iu3SAiDBA8xXDe8MXGePLhYlF5uIYTlJUjIHPZLT8J3x2UUo3wme3YcU3sTmGsDkGsZkhNvPKhM0uzBqXwu2pAptdBja7CJuZFZtdFmx21cZmFo3N7HLYzPh6t5ks0hTCLdj8Pw3nHKu52Vx1cGSGi382nCsREqYqhnhkGM7tEcO5zbQ60V6/4rGc3awqfEtuD23JVfskp3GAJEoF6L/CeOaooAw4E+SLj04Z5w7v43lsLwVtALWTIuqTrY+PTurICTCryiD15MfEiLUtcflersVXgw6S7yUUy+XLyPeWDR0Sx6B69BYCYoiE8r2ZGNmLwQbcqkEflUG+dxiCl8OU7yUU2mVDaEdAmXc69zAlLwSY2aAjqiqqArCSHKZ8bxfyPUy8ZHQiWr6XyfWxF+24ckfaf5HvFQpDAJR3IspLiPL8HdpscGDIWwr/iJ+fD0SD8/OmUwgaSVggkQpjCIRYJkgkpgpFnxe+9mQuEXHBiqtxgAuCaSBWEK7jgaWqRBYkkWt0vLGyZR2Jl8XeQidA6uSAeomyiRqdoWyajauSiTa9MG2/aT61GFXjovTRyBcu0Uf5F7bX/oIxpDjUnIEocnS1IKjyrwiq/AcElS+PoBzoBoIqHEGVKGu58i94qkQhn/L/DJ4yoy+XwVPlP+KpHIWnihVPJQueKv+Ep4rAU3YJnnouh4FRSCJZ0JVQU2Dx5V7k1h4+yQxnV7aQZRYtYQBlV2XOjSntj2wSZRFDRAktaKIlzvIknC+Jc0WJZi8OBQyZf1QIGAwFDBIeIgKGfDkl1YGBdxEBw0EChoxKqmMCekWAgIHU2CJgIPnjkgXGCggoRuupVrnewQeocE1V4uIGoKMpbkgoZds4AMXYJIHFjCQOmSQOmUscMldWHSRxOEx1laHEIaPEgZZciephEhoucZClhM4WUKgHtb/pFZ8mKQdXBuNPbaJDppgucfGdoO8SpmJudkVvWr1QldKEHdbjuYnxRN8a0/35cQInaggOUP1GcY6yf3IW7Qn0itrE0AvpNGV8z7+fH5oc5DF0eMwb+ddLQ7AhnqV6NTrHSP9a5TlexcagqeIYyVEoDn7jfhAyF8ulVox1waTlMBy+2chdfOj4Mc6QcZuP15S6MAT5NF5T5jXly9WUuzBExYd5TYXXVC5XU+nCFO77r/BoARt31CcFV8aH+AS0XLFJC6L7ePRiFoY93G6ji3E4G36OcvZmMqn7dOXqKHP7AR0XTft7khBbQKggjyezPsZoon3TvKfMEv7IPWqHeIqzca/yVlWe7HUwinZxPJZWCQgJwDW+R1SnojzReBWbUYXiWBnlKqYqNrOKbFRpw9g1jI4H5J+WcTsTJ2y8T+LqnaKrfXzGGVTo9B2rMElWPOIDQUcXnmwdEBFnyUb2AJxZhc+XDefLKTy4nSqFHdvxR+ZxFSByukDx11MmT+AqM/n6uPhmNha5IkUuLPJe9i0MvBS73dFvkSehxKcUJvgGnj6A8BK7gb2zI2MwhoPgUDhSElT+vev+fBr55brux074L9v16Leium59K7rr8Zd0XRZ4bZ0Jha88m5Eu/Z+7npJPU3W5rqdgJ1yX7Xr0W1Fdt74V3fWES7qOOXI4dvkNVBSkAwfDpA6M8lg3Y/aOzM4R1XcN8/F6cV1YXPQa5E1F1gZjHZnpYciXCK8SWRuMdWBMLAqxRHiV/7E2FJIjOdR5l4E8ev6UZaVQmmZE8gAAiAyiaIczIm51pY9RKPMfvkx4MWKdUdFpVlQoP67x3E3PUZTIRcqFBkOAdY00Xp8+Y5YrLyhxVVHGzakCKpfpbT5d9LbCeRL9oPA4RRTLer5ZMdWsmMJ/kviPn/+AagcTa7yWZ16NNK+GGU0RzPWUCUE7CgMqpV1/tRseZOafhvu3aL2XKNTV0VERfFVc+c0rl3ml8kNZB+O4GnLSyDz7bYo0TcIsQcC9NgalbuqcF1CQqXGCzALCSUWN0kdodnBThPB4YQLCsXtKq+79/wz8rhk5scZ1CsVFfJWRFZaUxXkMobum5m9+biA0k5WDXvtnlT7EeeC/UlS9jf+6u3+76PvuWhkanvOmNKmyqo8WKu1+zaKR72TMWB2GywHd58QO2PQxPn147Ckl4bOD9JT+bMMweKOhGUtav7Ft/VvQ0F3SwrQ8x1Gst33eXU//2JxlweUNrealN+2iVIQsaVrLSlUWGUe1prIVlkRRQaaa//3f76fR0P9RP9FVbZUZqP7W0XKaKHNW0AQNkAhhj0PdnfcmtW/y/OLyUAltZYlaJ6DWRjphbtzMcJBOtEa4heBN441MCnS3l2KBPVRGrZWUlJgNhOgYm5W43Lqx29LozrNEkpQCCwRxgmULEJWSoCWHkg3aLsFdC/yve3HyztSQ9EfX0u4P3LKpTt6m2xEWNxLMnkOYQR3CFrrqfrDTnA9O/LFmY2n3rW+8vfHZM4GuUPvVW58u6jdtyQehUoKxVFoSCnm2BWwxhXJBQqHNCCdca8sN2s2IUAfJSHrKaDz4AMOsrsc9jpF5KlAuNwk7IGTvpXNK6GwDHuPuwbVEbtsu1ZOLievQjuTEVFc+g545QVfBY0RUJRfbOE5tUKB7hUyGInT2vvSAITyAHdPn4154vJG2mkw26/iB5fyUdDVeL+wtTg1eF4jjx9eqcdwr3s8PjSZ39FjM1Qj6LY9IwO1ur0f1Gbqht1ZoIh2ejskN9UpjzPRZ6jSdrJdDHcDNyZE5lCRUplw+MQg5ipuHUccTxaezFZV8/m4OED865kLGhNzENKRLvozByNFgQEO5GotOjPx4N3E0g8iN1kLEANCdPxTCpFD4HZlrxQ41nvJd84OsPGoiZzNOM5yQBuVVPTmqM9dIPwPt0IB5nk0arJFLyctP3/HyKJiooeJZ74UTA8l6G9WdG6ijt8WfunSUBYZRKTD+ghw6dw0+idGoqfwxPq0nLsdh9I0df9IBuiMw8XEMAouiXrA3QQp14eiBgVeJdI4OfL2BeWKYl++8e7ka68Ue+tR0VSCck38JQUm1jXzk47qWBuNqxVnFvcRzn/I4q1iRf2Jd0MDTcZsQVEF/rdf8tV7DswvIYErkis9eHLz2/8aXUUCLJd7KvxrwG9nSBJb4LOiBOdRzUc9uwBevnC9ORfkfXY0ORiP4kpsVDzT8L72OboEsKjz5CDrVTMkx+s7h4FcT/KfJYczoV4VW+rS4VCv+6RsNI99o6IFGGq4r4eeYCSUFY4WDKuGTFWPRmkGmYKA7dSfBT918sZvqUOtMCgTgccMcalxN8Em1XsbomrpQyaMGMOoFMVKX4R2/yRKGk3ErQBYwDKbuYRq7OF5jOLJP50lE4UFP6t80ju8+gcuCkPJ8O06yxQRiuf8FuoMVFbnwECEfxsjHkkKLCcdz+WkxsUg2Qd5LtLzLJy62h/Gyg14WvUrE6ckV+QjMI8MbYFyjeURRkIelIx5QuGMwlnZreOtOa7+cqhxpGk86ks2mMdO9jyxLChqZ4LZ+rCwx2YOPJETTWhPlJE6gyuPJ9teQ0uUD3NHlK8Jy/TDpNAUOQgtL2m6OUyWEZWYBE0YNYG+YVwB+csmmzNM5ApGJpcLkHC6jg9SM1CaNJ8flE4OVxOSoQo0ydCZDQVIdE+BPZFHGIk2MBdjBqHzC5Zo2W+rxU1DwFDneoIO/VcC5nXk6qyMyAdQTXiGBEk15UdXzcubl5jhjNoHv0RmuKUjkqd8iKf2l9TBhmKJ6eXSvjzI8cV4CYkAiMQ6RW9eVE81MOyvs/yr78/0/xP6SLsv+Ev8H7xOpfbxqLKWMiA14+bGciCd6CrC5WuRonD68h6Aj/42AyhHSJF9CQOV1/2fkk5+EYRCWy7wV/dUEfsCliTJkYPVw+Sgql5ubj1acAclTGZns1oSbtSk62K4zHVhZiFNjgQZfbV6yBRpJkPA9meL6OK5jWixCMn66bRQsCS9544gZmJuILzH+DNVUwoVxiAtx1u9Sxg+xXES6VLtxyAmOBleKKgd9udYMh5jdUNYNM7Csr33NOL0vXpUj+IOn691EhmEijsD/++C54pQBzjy5MCTl8IOhOJLFY1cx9xWByEeJAz21ws5UW6xNkmXmsATGNuLHTNk4cONFwzSQIC4STLkq5onOWvObU0UVKd0iWuMxIrIxySU8026c2hiIJcWBxwfIpBdvzpJD8GZsgYQ2oke0JoNX0Kh5/tgmiK/QZGNDJof5aaLG8Vad8Ikr1Mb8RizaxiSfTMOpl24QUyPzwUk8xavZZwrkNYdKQmGkE43pw0Z8LHy1sfFVgRFx9CGOYzfwQGXxnWmIhPFoJXH4ZAuYyb3zH9QFA8I5+JozqhSg7YhAm+OXXKucyFohjs9P3edUbEotmu7lLIafaEgrwpiAkXwC8CVKwh4iWIsLl7gw2x3M2y0w2pVU/0p4N4BnTHht/38wSAzQDklcEpBo/0oc1OZFxs4FrULB0L3I0MWiQiuSLJJF+clsJb4+zriYUrsb+AaxIJshYlPeHdnk0AgvmcOLt2q+yilHJLzZMgIXd6i8LKwbRTh8I9FaowgZNFtzGsOj/HPeS+Hc6H/DuZEBZwfC2aHb+emFBF1i3QHKxOTnJ3c0wvzREpaukXAIEh+SKFxpKYVrF45vrXFqF8hyzvGe52Mw4/40uVCxHnbdFuSxSNov7oCzMaigLS9oM6x5dv2PgxuLbNwDqqZGG6//uaVxTwp6tet/vTmfilAi6cZuoz4jcmehMSkcCrLu7YbeX2/I23s3hoIO3l1A0JLIU+gu5mJDXzvLm5rlzWsv++a19GYhvEnbK5d83F0RaaLysh+v5B+XqQnrm1mWNy/78Ur+8WkB7v8OYNiw4GcDDHa9/M/PObgQPDuLbD19cu0eti0s+CKBerhj2dIXFseeqNVD8yl+R7GCh97Msrx57WXf5D18mI/NDjP2A/ZDuhykUi2Qqr4spKp5P2y1IZVqgVT1ZSFVzftRQJCCfvyx5Ye5ABpCX7Rgztz+8ei2g34wbcGdrjOyDXbaAu2ZiFQaAgXFYc59adBVEmQ8KUTS5KAbsLbbVWh/jhufq8f35hm+VEctqc3xEg9141IboQ2lrcR4KKg5WDTNSjDlV/eJ45TW81LLrimF4pgSlZWUGB+V6WA6yxevxNSQMSRIYpoJngCRv4ytYfOb+qhXrJz5UOdSzOsf1ZqHOsBKVFcJX9mEQ2hAd/LzUtEgzgcL1whNHrHHtYBuNfyPcybZY+HP2k1sVjjIao2d1Ro77laswwnzC7c7R4kpf5f+97fRc7b2u50Vlbdp0tUheJYeP3ceySEmJbbhA8rOXkhHvqAIQhE+lFrD+qaHv0TRBEmT9ZMP5FA+ZV3yf06StI0IKo9Y7VY4gINMUEYoca0kkKm2XO77STA0yohWytZcjyvRBG3ZWigtVZXuBZ9+cneXL368trT7qadbzDv6490f8M2C7g///cYd39f/qGtp90+HbEoNSc3R6Pz8BX98fPx0DfQpiu0uJQdOmYf0oIm8D7fkh0N8y4ByREoRMzducpWWlKpSiWo36mqloRLPBZBeI7TbmiKD6Hb0DsyfW1bX4MZJ5AAE3KN/dtNKsX1igtj/GY+z45gnRzAP8U48NniDKvkP0ceV8caOtCTSB7nMdqwPYZa+wMcr4bl8SeWV1PyltS9xSdwrK8i7JOtmU1A2BquYfbbsHZShB4veAP1jcteF4vg2Y03NywQUcRP+mbaWjNfULJiQ7qO+Sprx/phqgHjEPkaTREiBYQ7wX/dX6rCEz05e+KC0+w8jhzdaXPoAzny/1M+/uqX5M3iZ+F76qId308bNSGqwQgupNuO/7uqQ0m7XPb0XXvfXSw9+PDCAmz1xuQe2Bvfm4+X7ezoMuPG5tXjpPvzl7qkPfKH922YTnYWCI/qWGE8EDIB+/sPcMoP+zivROQb3Wzzb7ZKtQHi3fGIiStEfB7doqrQichBwUFbN/7przidiOoWHhGEdPP7kXR2al2KnTmd0vXb50HIc6Q/qLUU7Bh3Epz9vWf9n1v7P8Wnft5a8yhZ+iU87Tfrtg/V3DQ2HVGuz9ZOvvqP//DnABNK/viV380/zsWrDq4ceG9ykAi9fOLHqi3uHvomX7ceeWlJ9/Xd42ej7MynDu26IhkuJdQdOUqXSMpCwpBVGSjD99LtPcdYsR/Xg/pX5Z85WvQYDW3p978eqetXD3bOWr/U+U5ZxD14mKePuCOx9EC9HZpwOpLaYhZfj68371NfsIbwMHMu51Xv1ELx8dPK4je893z4rhAsu6iv3bl75YVWoUUVp97P7f7gj+9b+uDH35su7Tt2bOAIvhwczZr1x4zC8XFi284eYtv3wssmxtbqtwRV4OXji+z/UuYp2+a4e5huccNWscIhTtajBtBrf7ci4DvCZocdWHctf8zD26ug13+5JPVuGlzmNF4xcV7MGL1NueSbllLwcL2NWpQVfuzcfL4tvqd9k/u1da4+gu9bp8FM3dZoGDS+5q3XOEFsx9inj7KTEOadn4uXyn7ZdNzCJ+n/3ikED3Jvb4eU3j2we9/7SE9jp68ce7yw6DQvcuoMItA7k1xDSPhmIrmVGQzwrv3hyJMx3FY2zdKQyzBklrUSyngbT7UmMLGfm939NXszWZ+PEs2OyDSmKXID+A4bgKxksHWjLuik5uoYJDGQiUpalBmTlYyA2kkgnMdfVx6rO4QITnHjKLSRwAZ3Cg+vVyLLk5EgibqUz/zfYI8zs7P/WuGqhVL9G+UpL8frCa5RjOIQ+5SV45G4LZc7rNH66LuLXLESbtkSjStFfAdQBKsGrEF4RfKlguVlQLArsMPwXdFu+Xk3Dr3zdsM1As6EApSimR82QVndrNbuAdD3KuIAnjPu/411XHWGMiIcP0STbPKuQoSIUCCqumd3YrThjBowuZBWEMVoAt5wNIBaWCviIOtWaqIOBnyhxmsc294gGK+VVgYolIctTyjodilA02mo2j+Mq9fwk29GRgQ4InvaPmNCnNiclFKDZrYUAShQCyP+KACiJR6bdfPGt7Vn9ozEDHUm7SbONhhdOL7w9LUCRejCFa18XSQJCCCCQLA3xRWDBIXOy94rJVnjBdrOgQhTQ4/UCt6wYYY9gBMcHxAGQyEyk4Pggm/jwfQQfxPRSvhHPin/HhykRdCCfgf83MeF3O7m0IF+0pqi6xLnlj70LZ9iEhHQ/5nTAmbzLcigwigvdqzr/8Xe31rOzhvWwiFuViNuAEFsOH/ob5DB0sHxj22ZDJuEIQZUr4V0g9AEFjSzdJ2dOvbqq88lrAxQfb5ZrWF4YKd8YUQxY979ntMjulfybqVpVglD0fCio1BLtldqmbHldUDE/WBqgEBezQ6V8FlGOBTQrgX8F/0ER7AeFU0WZpCWL34Y92k+n1Rb3mHUX54Hw0/nWo7N3fLIXnS/WffXSs6l7kpBNPDLgb5Cl70bOfg5F6fiSsJXJB4388i40aAMzCNpLrCfSwZOyiMxNgUqluCxIiEMKWspdR4xwfbLKgjgrS9RxxeK2EzkJjrsCi/u9YQ46yyBDxlusgkuLSgn3oLEseSQEzpxXu101O0wCm6x35lhkfhJHZ3kLsAXjjUoRvK6eaRHMBZJQg7t9vC27GEVilOhnL6GWQwEj1xe66US+Q8gPbXPPm19kRZmG5+qhHlFj/GEzQfyToh+gSKD0TwvawqRy2ZBQAnWoiaMsI+QGp9yeFpTDKHOptpsp/zdBT6aqDkEM+TMHxgtv4gfYidVOca5/e/pYFnTbpFKkOJY743ptLmndEdKMWyDlNqtUvzbX+jLeRRrCDR8nyYlBF5fv3QbqyoyFQJvF81xiSkLBGE5V8Ui/kPgtVd1AT/BtS30aB9QHlR2bxdZC4rcUNPwQ/lklgF7XnK0a86hFEGM8XiZ0ftBiPCdtIKg4BHPixEgQw7lZBXxmVm2WbreSv3CIu5uJe+yWDBJ3CcryRO2XVxDDKOUihdBsHKW4B4z/YZXjFcQDHHhdya85L6kweQlewWhEpe2WShVmpfXRldZaKq0xK4XMSgzPOlLol8sqnGQbeCF1awsY5NKLi6bl6KuKphlU04KfxE5Ajzxai6UWXahht4i4KxcQKwqkdOnV6MUJ//SioFf/MfGWiXjXlW40GqgsKCBvfJMHZxUE3d2uevSFdUEOpTCNzd2tFfIKNh44J3T1QoXBNYN4fGO1cYvnm5g8b+bDYSzbK8pK4OaCeQM4FUKeJ9zh0H+N4Fdswm9OhYV5F5mPL4QJrEg9UJ4MRyb0OL/GXSSFoyRHyFK3Q5pGLrXw110ASz/IF61CopBN3/xAjpk9H1DRQYVOffq4HH3GOJ6IEw+1qZmGJj5a8tJsAFJhgTFFY/tHH8noMKdHA1lJdd/s484KDnzRLByH6O0mB1a8688jlCUkqWadapzfiCmfFjV8X4PJkCZGVevfM43THhSoortGMKbMew5uSopZCStd9p8ko4fUMw1POZKxSLac5VgWR/mOzLdw4PyVoAvbNNHKiWDEnRkrxgYceEJTTz0hP+Ditj8EXxSUbPoHThQWoqFFKn+Rvw88nm487t/TKlBGJEjcN43GauuasWC4w2PIZlmgmFFqDype++mXCwDhZQvOivlxFZh6HIDKxH7MeqCv/05gcdBbGk2dCFWxNOgrDcbSXjRfS35C1kpCULu+/Ttz+eDhOV4QJ4EclwYTQrgqYvCcxjiYIS/IeQlqrOrDJeIDlKdWLhit7DVbUXGvOYZwnlYUfDyGiLmQpL8zFs+a7yxrKmQ+Xv6dWFN8CZrP54jnoWAs9GyjAb8Y6I1YJrSC7KYyQRO93WmZaMvZ9S5AUCgGxYI8ZejQ0whOusxJdUU0B9VTghwpFhPxo9CLg4QVEMK9cKFMWlRJhB1xGIsqySyqpC9k6JKciV1el5T+SZeMgTGbmoPzUl3SadElAftfLSB9Uhb2eArv858SI5PDGHMMHwvRCWOeAWgDncYz8avMoqaRAVCXyVX9LRc/6Ah0JrhGQWl2UIG1rhoMgo4bgrub03iE1Q6Jm8P+72mpQSlKO1kRrZ6YNYuKCmeG1ctNfESNHJoWtIcwF6OhxaAfB+ItcMQgs1rI02qrMa9JTMQNFbl6W5Y9SJMkskkAsH4Uyzx9Sk5AMjQKswoUXKxL//RJA7KOVRBGUPt6S2uDFaO19eP6UmsfO0XVqCpQUD2S/rkhTV8SRxmh8aEhCYMCbjlt5z8atbm+UduSDeSOm4/Z5W3Z7D/bsk1DNPNexsTNokzZERM3izJmGyZuFmXLZp63FQWZrFJQe7v1Ao1SX7PmiRqlT9COzmRWj3uG7vK4wxF0pJUIN/vpmcjnVqrwJETbJw0nB2wRU4TkMUIFQLYDEbf7UNpN+FTDPS0Xinoo8Ir/uk+8bfBXOyf9AmrZ80s6huZMS0IFTMo+e/ZQ9+vwMkO5/ePg6NF42fEzx6xzw57Aywf/RhVtkxbCQyHNtg4+GM4f1/zPrqXdT7xQfWXc+gSsOtK/sN5vTdriZfLMyr+3f3UHXi6dNebE901m4OXf+ltp75e8rJEDvkR/QWwKkR89pnKVKEo0d12QDu/DD4G8BZXKQOCGm1BJ0L0Sz/Tl/F3uYSGuqrsMaVnE5oibbu7IrRu35JCkuS2aJvUAPbvcnmf+D5G06DJIeuZ/IWkEOdF6bSAUZVkwXq6FVJ6KqRIeH+VZP3XUmGHZU9iY7CETsifms/wh4wYNHTtpDFxlTxgtLsdNGDt8VF62cZc3ZGj26Gy4Gj160LjsCYMmjRmVzx7IHjViZD4bOyF/5NhBI/lN9pQhQ/PZ8Lwh8NKoKdl5E6n66NHqFSNawt8uavaUcdlD87OHqePGThyVP2pytjpm0uj7sydMZEPy1dFjJ+arVwxTRw+Browaknf5h+rY4Wq7KzuqE0aNGTGRjRmrjs4ePXbCVHX42AnqEHVY9sRRI8ZkT8BaVzyo3j81P/vSSmJ4UXXg6dQJQ0aPGqaOmqhOgHEPa6k+MArGNikfbvOH5I8aO0aFt3NG5UNH2MT87HHMeM5wjCx72Ihs/B1G/2SPyx85CPoyegje5mVPzs6LwBq/0fe2Qbfddtug7j1uuq3HNWp7NX+s2r59BEDU0zHqqNFDRmS3GjsuHy7y1NzsCWOgnch48vFqyMRJE7LV/JHZly0fPiofhixKsJIx+pFj84ZNVKFuHs6dOmoMfG+qOnTkkDFYc/TYYfDvMIA4GzFp1LDsQbnsgVHD8ke2VPlcw5zAlA6zTGk7/BrMVPaQoSNZq1FjhrMrJsKk41jHjM03Z5zxrtC7E4YMGzVpIkeQf6uHqEkfBCSEUeGV6Cd+ULw4fBSgZbaBu2IGcBhs+BD4Z0L28Dzo6JAxQ7MZvMTxk6YY24CpmahOHDn2AfX+IWOGTeyijhySN1yFFTI2bxJOcUuzEswLQZFjC+NDEN2AUYwefY3oSUu1LUKkXXbnlgBZKB8zdALMFaAtoBw8btVZBfzOg0f5JhAtKILjBgQYO2yYWCORSgTXLvg1hPiISMHE/AkwVdSTYdfA56GvgAbZkQom9mG5+XWctMvWMKf00u6JGtC9lhx5cVLge1a0jrwnJnrcFA4l+Pb9Y2Hxt22pGkscwBSpfrlphvFO5HSEt0AA5PAl8BrAjrRy66BhuMQnwKReijHYRK15at/WAmJ6NYqItYQ1OXnQsOwRE7KzJ9InrbRPBXKqTszOv0YlIpg3VR07hmZiTHb2MGjQxGbArIkGMrXk05MPPSOkmjgSMHVC04mqFQ1qLwSzwEB8xGFYvWKyoqpbmjFqR+PU8AljR5tvimVWq90IYZnYFGsNhdnJnnBPu4FA+0eNGDUGr8SztuYzvJpEWHLTgBtvZEjAxo6ZaN6L9sx7PvBWXcWqihRcUfsdxDGTyEe/bt5OHpI3Kdu8i7CECSbti6p5zxXDBtb+ClE2oNpE36kCvG0+GDRkyqiJxmv3Z08dC8jQLruD9eWxw4cDNgDaGNUQ4Thet1VHTwKMv5/jf16ewENCqTGINfdn5wHOtmVWfIsQSDEtGfByu05tm7ExQ8YwhuQW/txkY+wa+JtthxvJ5vL669Zvo9898QlW+89VWfRTdHsWu+yfSi36fq/GT6r5QjOOhea/pzQFSm3irwP+zvy9lHW/aQz7q1ky23dHU/b1VefZ/V9VsMwVjzO9+Do29Ja/2YZvXmbrhmxjXcY0Zvv7dmN9HJXMfbI1S1+yj52q/zdr9kY6O971BXb+6hms+4bW7OkTs9jbTcYxfdog9tnizuy2mZ3Z0+c6s/mDZrGM3zeyCw2vYd/UPMnilttZfJsqFnP3fDa64Wj2ybQOzL2zKevZbx17drjGWp0cxN5vOon9eOojdu1DP7PfOjvZklvnsT9zT7KGbwxiroELWVvldvbQXz1Z9cu5TC3/hHU4t5J9/2J9dt+QxcyVdpQ9siKbhZIGsYVZI1nRoRrWdGJf5nC0YztuT2Yfr5nIHjoymOUuqGCpW3ux3SO2MPfxw+yumc3Z/Mlb2fPpT7Dur3/NUu/Yx57ramd2Zw1rP01jm688zpb3+4ZtePhK1uTaLaxBbhVbdeE+dnXDLqzw7A7286P1WUFxgOU0LmCfjvmDtW31AEu+5jr2TtKHbEvqM+zVrZtZy74687KBbPbDPdn341uxpz5cydrfz9jb+wvY2y88yToO+JR93vVXVuZPYX0n/8WGPdOcjfv8ZTa04AJ7cO0drG7yMVbR53Z2zWdfsBdmdWKNG+1kn817gN3dvxFjDd9jP8eksdQ937JV7WrY8AY5bMUdQ9grf/Zi0woPsWD2Onbl8bnsaHgwq9q6m+V1cLOB2kFW55vP2Z3XfMO+eWoJ2x/MYBmzj7Mjd/ZlH+64krm+r8MqH97J6lbczH6p/wJLqbyHtU68is1MuJ/N7C2x84/dw15dW8ganDjLel9/HfOPOMBe+voQe21QN5YzZA+LyVjNDqx4mzmeP8vufaCQlW2eyYZkzmHzJk5hry+4m439fCNr9fxQdi68ky2cXsWabBrBBuzowXZ80YFlrNnPNg9ZyBI+foDZmiSxhJ5Psa13bWXbt3Vnfd9czFjdX9jB615lzfr8yC5+6mfsg79Yg2W72Lg9Z1hi1/Ps9M9F7K1jW9hHFzLYUvsytml8V9ba/Rbz9PiFzUl4mr2sPsRav7OK9VqymT10ZRvmHTCaTXihmOUea8ja7XyCTa1zPdOnHmHnvp3Lji97kh05OoutaPckm/NTLhs0qAPbcDGW9V75NhuxOo+Nn9CNLRx4JVuVvJ6V/+hmC9tdwX7L78za2tOZzyuxG1wjWcszd7JeLxWz/GMy2/hZY/bbw8+zMb0nsFV1qthjy55nby/+le277Rb2ScxZpi5vz87fMI29CWLa110HsayBCntkbiEbcGsz1nFYBRt9yM+u7H0lu+fGSeym8QdZj/5jmMe9iTU/P4olDf+UNXU+wwbabmZvX/MVOzl5G3v097qsT+7DrH7T99kTo5qxD3e9wl5N6s+Kj+SwOV/MZS0n3Mxsqz9gDziXsV/ajmPsr6bs5Pg1bPjmPmxY5bXsya9nsjLtSXbdsovMN3sBa6d/w5Z0foZ9PW4Bq7vuGHN9ew1L7tiC3VsUYncXLWX++CUs7vghllf0Ovuq5gbWqTiO3ZUymd3/XDIbsnMD+2jue8yftZHtP2tjfSY1Zafe/ZV9FdzAYpJeYnObtGHDZk5m7mvas9hl9dgtXV5i9cs2s9d/eo3d2ySBjd7cl7V68GlWcfuTTNFmMnf1r6xF1gI2ut0K1vltJ/OqyezQlnvY+SVb2Yev3sBu2vEce6Hjbnb0xQ7s5SXL2NfdRrLUod+wyQuq2Mj5t7K/vurIXit5mX2b3I7BBfP++SUb1nc4+8m+jjXLbsvuuD3MetV0YTm/v8cmffALy1j6LXu5CCj/gl+ZbWcy+yPoYF/8UJ9d+9ZqdkfaItZht5vd1O0ES/xgNWvf6B1W/VI91i97Ddu/6Tnm0eLYPVN2s0a/T2YPzbexuXUnsA+fv42NHXOEVZ1i7Knr72Rbv1zHXhr+Ppv8ySdsn1yfvfFzK7ZgxSa25dUH2OzeX7LfBobYh0Xn2CvVbdjXp1cy7d5ytveb0az4o4as+VfvsrIrujD2+kr26m1L2bt32FizVm+zG4qmsS+dL7DJL8Wyh+4qYXUSmrPD61qxP368yOZ+9Teb+8FF9sPkPOZ48S/WtWgce2RMMrv4aA3L6OpkQ0a0Z81TZrO+G0/CenqdLRo9hj0+ojNrF76Hzfq8N2v7bR32Uavr2BVDrmYfj9vD2u5cz8J5F9lqVsrseT+wu78OscDYXuz+hP3svXtnsXFD+rDc2yvZilsldvOAjqzBp+tY+5+3ssQxg9jAtj+wR1q/yOq/uYWVXNmBudatZiffABr1W4AtGvUDa1rzAPMqRUDXW7F+u0NMfW4Fe6v0AGszMIa9/Xs3Fv/lTvbwB3vZU19tYi/X3ch2lE5nrpx7WesBdVlTNoAVJlWz75yzWZJnGHtCX8ge/eAb9uXF5iz3infZQ3OvYvZf/mbvhZ9lI3P6seubr2H9tt7NWl0oZ5/fvZyd++hx5uu7kKldnmer7xjEkrQ3WFGnx9kuVWLjv57NPv7mXRYefJ71zY5nkjOXLVj7CnuzYi+7ZUBv1uDPWPb4hC2szHENq8i6mjkOP8Qqe+xiNzX7g322Yzs7/ovOCoZ9w54adoh98UE7tvrJLeyBOw+yUd9vY9VfJrL3u2Synik92YBJg9j+jefZmCUfsldaD2Sx3X9i6V27sSFbH2XNLp5gxz77hQULdrCxi69mrsptrObzhWxMzhG29uKHbKlrEysYmM9yX32T7R7zDOs64SH2YXwO++2TF1mzid+ydz5+n61jt7Ajb/pY/vuN2Y8PD2b5h+YxX3JLNj3Fy6YNX8akZnXYqgcns4sXP2C396hiXwDvPv1FIpv//nts65N/sXZrmrKfx2xhy7Z1YIfW3M7eXvMO+2RXLEuY24qNveMq1vL2uWzFnu/ZZ+p7LPe+l1jX5k+z+EG72EXP9ey7c3+yx64ZzY7MbslOHJzF/nr7RVZ1Zh9rffXHrE3nIaxToDtL+2I7m/5XDPvz+hzWJv0Qu+3tWeymFQtY/+Au1nzAYVbx4WfMk/oEqzduPRv1+DDW5O7BTLv1DCuMj2Pn3olnf+08z64qbwV/z7DjA3exr+8bzEY89hRb0r6KfVx3PRty51PsuzvK2S0zP2SHuvrZ1+N7s1bpX7PXU0pYoGVPdtcvn7MvHlzOnu1fwfrN/oPd7viL/Tj1NTY32IF1ejXIRiw9zAYcf4nNaNKJ7Tj2FLvFt5qtaP8Ge/HzWDbK3ptlv1nNCue8wObc+CT7fV8HFljyFntoxvVs+ScBlrXqMDvcawD7Lr8LG3GqG/v7mW/ZfQcHsYdGrGbvv/IgG/BrKWsxpxHT3x/A7hrjYoHms1nnXjPZ3O+Psh+fPcj6/JnFam4/wdLjdrBtd81jy/5owQ5s2sbitn3Cvrr7NdZr22z2yHX3s8Dsa1jLqcuYf8ijrPmND7GilvXYdeEENqdJMZuSOZet2foD+/Grh9jWLptZk3Mn2W8jAAeWhFl2WQt27dI32MYCD1t9y2HW9OuhbNR3X7OVy1LZmmaPs5F7Mpj7p7dZ91Uqu2n5DjZuxlA2raARi3vvSvbC+cdY0u3HWOBnF3sHZJqx0/qy51JvYe/8/jKb8e1n7Imvh7A6HWT45io2s7SETfhpNOu88EE2Y/2LLPfKe1nPpveAOPwT288eYH+dG8Cku/qyyvFFVuE3CyNO8KJV9/yuKDUv73khEw3Yt+yacg3ez0yr7oz11Cse7IT3wRnfd8D69X8ZdTX3sxmRZQQwMIZ+P5PDXa55tnzlb96NGy+iZfBbLbM/9+Re3KLuJ5iTpO7e1SPQTZy/t70b9xc6qjXeOqNmY3iP9s457+eu3Fe0XTf33P/ymzO1WV1ueqry8wG15PZqbUx4Tr1+1zyVeXX7P1+89tcqbeDhQ08nDh5fPqToga4rT1dp+4Y/6n/wvuLyRwrHHE/+vkpL/HXE1bfuX5CZ/0jygbVfVGl/PPZ7o6I988u/+fXrZrl7q7Qh248Ouem3wZnbn5qU0uOjKm3Fgfb3/FBWnDnzlw93dP2gShv90MyBz698MjNu7u95d75Tpf1VdXFJvXcey/yt14QWS16B7z3dZty1H3TNLN134MrTZVWaZ0zx3KuUnPK0A3+/PvypKi12Y5vmt97+ePkt9yTslZZWaQNO3rSgqujm8l3t8io2zqvS6pz79L1GHy8ur2z14msrZ1Rprw+498T3B4oyb3nsue3LH6zSei997mRyWlH5Q7c8nLl+QpV27ZXfDKhuuKj85MIFnX7PqdLCtyVqC+bOz5y0c+ype4ZWaU1OxU9++osnyg/ea5tVeU+VNrhNl66/nV6Z+dJ7I9s92r9Ke6bT7J0zji0qr//FX8Gb+1ZpC7c8310fOy/zswX3z7mmZ5X2sO2HtfYHizKfOPzw4j5albZszZrvLz72RGan+yeNebATlPfOP5ty36OZ2vNv9tvTrko7e6zh8ha9ijK/LjiS3aNFlXafa7z20PonyqcPPf/dt42rtHYvu0d/99uMzO++aXj+mQYA//DYek8Fri0v/uLLvYUpVdrbMd4JMzrOz/QoPzz/SEKVtmjnnrlLksZk3t6m64uve6u0d19e23dS35mZyevaxfztqNJuzH/liNRtdma7Qzf+NU6q0q6/cGBg568XZdbUGfam668zmu2ex64pKptd/vOqJYO2/XpGG3nzDbt+un5J+c4Xu3R84ecz2mOtbkm74FxRPvyQffRrp89o+zss63p83/jy31b9eNVXx85oyWl73kpNXVH+45rELa2+P6ONvrH5C71XPZIZvCrhxue/OaPNG5Xx4OCEpeXpRa/Yenx5Rrtnbt3ei164s7x5698CMZ+d0dJW9hnxVMuC8ifX3PzF+X1ntPhXNg/+aeh1ma3mDhns2nNGqxrmuMY9/InMO1j9n/QdZ7SpSsmX3+0ak7k3c9M7pR+e0domxGmP1SzN/ObA59XNt5zR1r7+4IY9xZMzmzbv8OmX4TPaA5X9T22svzTT9/XFFW+Ww3jKxrOrli0qf6HlM5PffO+M1qds6eFd3zxa3m34J6VfvntGG9QpbuOH30wpn9HvmdtbvH1G+/Xeh073TJhdHrdk4I7Vb8D7n19MsV+9NPPLpu906PX6Gc3+1Lw265Y/lHnxoycPJrx6RnP3Tz/y3dDizGb9e3/tfPmMdvLD1Jsf+eiqzHU975rX5MUz2tUVw1ocvXJZZu/Aq8ljXzijrZq8Ysj1Pywodx+e/N53z53R1vStumZb+wXljwzosnba6jPaaydazJ1y26xydcuuq3qWndHuvPP2KV/vWVp+RXDAjE6lZ7RhqdOKXvLfkTnxxRsPDig5o2UE7wtXvbW0fPc1hcOfDZ3RZrx31aOvJuSUh7/0TEqA+zMvjl5fNWJoeZt62Zlvrjqj3TKnsv+1h4vKZy275feH4f6TrndPG9ZwSnn+oNPHJ8H92ofnV1x/ZnZ5/vTneq+E+3lHBzS4MnV2+ccjut1+Cu4PHHTft/Pp4kxt4Df9RkH79Z/r+97hKx8qf1Q6NTEJ+pNbMaL/xdPLMq/c1Fb6Ce4H5H328nensjPvv+mTDr9A/7t98labbSVzyhPqde3fFMZ7Vcdrfn531NLyxD03rpgL8GhQk9pl1n1F5a9+1KhnPYDXmDsmHLr54LLyn5Z0f+qLNWc0Ni/2nhGvFmeuGD7vi49eOqO9fbJ6U5t1CzO/CjXv9uMrZ7SaY9ueHvxudvmC7u/UuRLmq/ugX+6a+etDmR0eSF7xGsznzGsbvNDQvbT8w5rFnntgvps1yJu//sWB5T9u272247oz2l3vFRf83iivPO7W7Tu7v39Ge+n3c8HrrltSfvNN36yasfGMdsNjwz/P2/FI+fvOHeN+rjijNd2zuMVfr4/PLK4um7F46xltw8SY767ePzqzUaPvU4duP6MNDd4ftG17tDz7x4EPDd91Rvu03ZHvZ6fPz2zf6vrTT+2F9bSh/MC+DYvLB17R9U3lU1hv7c483W5Xceadb7VNfPaLM9pbd08cM2vUrMzwxakDcmF9vf3MY0/u/nZG+YO/HAjnwvp7tP3OJQ/UW5D56oG7V6w6fkb744t91y96qLh8+LsLmznPnNHef+3w7V9sGVD+Z3K/9aW/nNGyfn3+2tjVxeVd7vpx4YTfAf5LX+107rOR5b3u+/Ps5BrA13l35h45s7j8ekdJ27X2Km3314NiPq/Jz9y/6YbiBkBvXlm+5I8/Ny4udzf4/J7NQI/e8r7e9rUxEzOfvvWRr59KBXp4cdW9V37/WOaDe2sGvaxC/bvc+xZVzsq8Yd8drX9uWqWNqHdTp9d3D81855hj2eg2VdrI1CV5LXNHZI4qrjqsdqzS9r+za2bKvKLyP7YMHOAB+jr2jxpt4KuLygvmOq9v1atK6/PipE6v+YrLz871uR7tV6W94Lz2+UfK8jMfXf3n4ZQ7q7S4YJb67OIZ5ctnflzn+8Hw/SWbPr357scyH7nyK+XoqCrthlzplbu6zMoc/Lb0S2Bildaw69vOwKczygc99VD7JwuqtI99va55r/nc8mYl55N6zq7SDszpMtj2bn7mr9r8Y62Lq7TxE5655fS2mZkzb/zoz1tWVmnViw8sSvhtUfmXxatLX18N9D+/0ZHlry0s/3nEY616v16ludSX9PItj2U2vXvImbT3q7QrT724ZVmLWZlPvp/bscW2Ku3MI/vavThsXmZWjzH3TAZ++9P31/zwfsfHypM+ePrVi18BP9q9uO81cx/IPFT87PRNx6q0ubsG65vst2X+PH5Ri82/VGmsE5cT2o74aOkdv7S+VhIuqve0vYX2dot7nAJ545NwvPRz47dWfKyt2u74cdKAbWHDlfUBsQe8k+SST8Lerx9fsQLqvdBjBEWltf2me1njPpu17Gu7ra6pCYd3fNY8Y9b4cq1m5NrrTq14L/zI3td/mzF9nba7x75Jibe+E171TeWW6qt+01jx0amFuz4PNzzRMmdKItwz3+YzYz8Ph975wzX47K8aq7wl8fvEz8MPL0hs+Pw+uJ+S0eme9Z+F9729zdPnDbwvKh4w8LPw+9427XsthnuWMnmv/Fm4UbdgyqrxcF9cPHvHmk/DXzR4bkW/W+H+ZuX26/p9Gt7aeNFLt7eH+6zcLR1/PRhOOvxM7ltJWL7m4gvPHAzfeO+Htw779bzG1sztvKTHwXC/lovfGXEI7tev7XzupwPhb4rv2Vn+PtyPW9R9zxMHwlPqfXF2yDNwH9pYt0HWgfCjt/dMuL0I7ot6Vh05sT98IPfYnieHwn1l205py/aHlxa+cOSKXnA/58sF27ruD8/s4ehW0xzui5s2++7EvvC3G9/8KhgH9xd6txj9+L7w599c1WvRL+fg/r2VI/R94ayMbz657hDcL69atvenveHtZVMqum6Ee/9XKc+t3Bued0XllsJSuF8/9NajvfaGr5p1sLF9DtxXz+4RPPVJ2NMqNW3PaLhfW3fS9b0+CfdP6Xzgi9vgvq3/2u6r94TvnvV296ZdsPxEd5+8J/znhWT9HRXff6BZ6eDd4TfOdf1yhhPuix+3SRW7wov+vmPgojO/wPfn3t5M3RU+caMn9MWneD99Yd3pO8MtNvkrBm+E+70Hdn18ZEd4/ZeTWjR+Du6LE1pn9dgRlveu2h1cCPfV9Uc+sObjcPqDs7bdMwnu2/YeNdr7cfhIh1f77BkI9xU9nlfHbw9nHey7fGpPLE96e9FnH4Ub76zZc28buB93f+b6zI/CfXwlkx5IgfvBHZ9aWfZhuLhz147bJbgPrevfzvNhWL/w+IabTp2F9xtPfnjitvC+F1PlmE/xfvOihw5vDTe/uG7N7x/APdt/S8ueW8Mvp3kfTH8R72eWz1u7Jdz2naTBE5bifZ/cFWlbwudL7rjjj4fhPmt1cf9HN4fD19R/6q2RcB+aeuG9XzaFN55fNPOZ2/C+5RXbB28KX+P6+KV1XeFe/e2Owj0V4XezXmwhNcfyv/sczqwIX6nvemJqMtwX3VC+8Y5w+Km/9tdXJWw/6wlXxw/Cnt59+5w7/TPc/951ed2N4VHZi249fwjuQ4duGvH7hnDBtDviG22D+8Ft1KmH3w+faLIzv+ANuC/KOLal4r3wu/VaeqVn4b5iwls9n18f3jju3YfWzoN79spb0sJ14XfLq66Y9wDed+rxc/674S/b3Xj1wmH4/qOjY+97J/z1oKbF790C95Ul39zb++3wjfuvXB2r4fdz+n7R/q3wl7/7J8xvid/fdmGq+ma43TunM9rWg3v1/uU9Y98Iv37VrC//dGL7+3Py/ng9/FbuTXFnzlfDeB64fuGXr4b3rGo+0PED3LNHfjhd/nI48FzLod33w31FQtbckhfD9ZYfKXihAu/l9nfOeSG8r8OHM9u8DvdFn424b/xz4c6JoeVfPYP32X3m3VsW/vbYra+/vADbTx72fZ+S8J8ZN7VZ9RCWn5pRMeHZcOqiqxe8k4P3t97684CV4Za/n37uzF14P/2T+699Ilzcct/uPn2wPy8t+DNjSfjFV6s//LAT3v+uPtRuQfjFK6cmZmdQ+cCrU2eFe0882bRxCt6f3qwkTAk//kaSw+bC+8ZT3bbB4Xp/NPmtYSXQZVY865eqsVr+ySGb00vw/tqr9cOPaq1XTF/rBz2EFW3eWrZnqbb71TOZv16B5XOTNq16SjuWuFjZfgLkHBa/59DaEu3lN3ZOKXoN7iukvffMe057yvtMab18uC86lDXz3he1d1bEzFzcBe/vqMpp+qp2+8rB7koJ6y//cfmktdryDQ/8KO34CebH9/35297UlMUFnrNLfsL5n/9167e1Pff+OfyVe+G+4o5H73K8qz3zzX0vtWyK5TlXT/4S6HrL3K5jzp6G+U6/6bqX39PkqS+Ujv4A730bPpqyQRvt6ji6yXy4V49dmXjdRs1258CNy+7E8m/Gt4sJawtWbWj/ThO4z1rcInlEhaYdO31m5vlTQH+WzHik1yZt0xNfTbq4Fe7b7tg9pslmLeP62d4Gj8P9zdue/1zZorXsWrXtSDbc+9tnbvl2izZ/zscjeneE+6IHczu8v1W7vm39wA1uuK/el9F56TZtWtXZR45/dRLuUxrvzvlQK712cLv6r8N98fDTF7I+0l6484B2dAaW1ztfkbxdmz/RXZV1B9wX/dq/2YntWtMbXi5u3hLusy7IHTZ8rO07uzQxJME9a5n+0/wdWlrmV41XfX4C6J107y337NSK3/jIfsVrcF9RvmtEs11amz1Pnm39CNwP7v3p1b/u0ibdsPrM+/diec+rNm7arXXqfeyZD6+C+8pP1ksL9mhHbx3Rpp8P7ovrVrgHfKI983nNY7cePQ70vWFCXuxerYDtWrUnDPd7l8auH79Xi93ywZcVK+B+3Oxncw/u1f6s2+ilpvlYfkP7Rzvs01wr33qF9YP73o1G+Jbv0wZ0zT7epzncF+2qrLmwTxssn3tccsD9yKGfD7prv9asrHLoFUeOAT9Mcrd9b7/26juHH3jrA7gffJ1/QsoBbfMVT4546Sm4Tzk9uskDB7Q7HHXPOqfCfdvX/+z36QHNm/jZVztuh/vKNt+fufKglvtuP4n5j2qZ93RbnCdPy3z87b4Ka3tU0wey3ifDCzOnHFzmYzcf1dY999nsFwofy3x17E1ONu6oduMV/XNP/jUk87W4b/+uWXRUuxh7141NpxWUl28b6mRrj2rSl4d7j9w0r/zXTfc2YHuPavFL+zyTrs3M7Pqr/VRN1VHttlZH6tmKppUXPTk7lvmPabdOdY8fXvNQZsKJEX/VtDmmNX50Y5MjbEFmTvz0b2v6HdP2Sz+PWSyPKS9+ekQcG3dMy3+6/+7xf40ov3r7tD9qFh3TZtrOP7vpg+mZRzerf9e8fkzLHrarWd1p48rZx9pPNZ8c09LnP+SaUFRUPrlekxM1Vce0135/ZnRGxcLM42VP25j/uNb+xh9v2V84N3NRy6V1Wdvj2vRf2r574u955U9PbO9gNx/Xyq/Ozg2H52Z+OLebysYd1yY9FP9Ldnh+uW3q+VM1i45rd+y8tnQMm1v+ra08yNYe12JuqOz0LXu4fF6a98eaT45r9lU1PcezOeXXPbb4r5qq41qncQ/ufWj6zMyPBv3RgPlPaMrb305e3HVu5nsP9UxkbU9ok+XlN9xUVJg51nnmaE2/E1rr+2u+qJ62qHxfQuY3NWNPaO93avLESzPGlfvm9ThXs+iEVrVm2OK0okfLu7Ze/nXN6ye0jkvvnleZ9Wj58D/7wPgRf5/a5NqjZd7y9M8qqz6hxdwzp+lL2rxyx9oe8cx/Urv9yztX9Aa94Y9fNzhZ25NayugW817+YEHm1PpP+tnNJ7W2U6d8vePvOZm9W5+vz8ad1L56+dC1k/VF5be2vyudFZ/UEiZvniWHHyu/oWu/5mztSW2QVpNpuziqfF+D1z6v+eSk9va44oRjXWeUT7Hdcqam6qRW9k1sZVdHTuY9vuyvauJOae/FNOy03XF35h07Xvq7ps0prX5mo/wG0tTyw+8//kVNv1PaquazR/prppY/nf1sYzbulNa13+y9PWpADq/z6O81i05pv2/Z/MQDfxdk9ttp21/z+ilta4uzZ5rWDC3vca++v+aTU1rg5DVn1tXklX/rHnqhpuqUdq+n9ZOKPr38tsnvfFcTd1pLzVm3bNim+Znf3/HHzzVtTms/fdh2YdXfw8ob/xA+XNPvtDap1+nykdqs8t/e6/9TzdjT2unK26rLps3K/HTRCpj/09rPS35f6Jg5MXNl4IoAW3tas8WmDHvs4sjyp3su+7rmk9PahJMfpX8w7bHMyVsvnqypOq39PWfVq50/eCyzxYWVdZj/J2383e+tWfzwpMz6v8X5WNuftC8/GjeqeNPczK1xU0/W9PtJ8/5957aOsXeW//jo4dZs3E9a97hNfT8rKix/acbhACv+Sbv33ovLFhXkl8+Ucw/VvP6TNm1IYFv9wgWZnXvlNWN7f9Jue6PmzWelOZnni7v/WFP1E+glt364n43JXPbry7tr4kCPHdVKzZpZWP719lu/qmlzRhvmStuxiT2UWVWn29mafme0W15etnZNzYTM+PvmHa8ZC3r3B1VvTPz1jnJfzbPxrPiMJm333LewaFZ597rPfVsDevw76nWfOtiUzJLChHoM9OYl994++IJ8c/lW0MRZ9Rkt/ujVA7tnPVIuL3zwfE1clWZfXNW53Z/9yj+a92MD1rZKGxA/8ewr0+dlLrtqxvka0Buv++jzg7o2LzP3xhf/qhlbpU2asjz9nHx/ub719+9qFoGeeOyBc/sefiBz2veVMP9VWruygpWp0tjyZ394IJ2BnvbGK3tuODN9fGa7LZW/1VRVaXc/Ok7qaB9TPmZw9rmauGrty5j0Pq9Om1d+54Ozf6lpU61VvvnXllGFT5bX9f11saZftXbPsp1X/R1+MnNG390KG1et7bz9h4qZbEbm8Z1nAf+qtXqTOn7wbc3o8uwvvRJbW62danL0tUJtcXmnA6sltrda+21V76l/PFyUefHil3/UVFVrFbmfjbPbHih/4uL7Hub/WbvfM3rWwaLHMgee+/GPmjY/a1UdLg77I/xM5hcrPwX6+7P22s0J4x5gKzNXDggA/ftZO/PN90d+v7gws0n/pn/VLPpZmzjhmsNt2eLMuzKvTWBrf9bmSErR1MIVmeuebXah5pOftRELVr185e/Z5ezgvHM1VT9rp+554Zlw4dLM1bPne5n/rBa85+Li3KJVmcp1jwD9P6u1D686tblmaeasX8travqd1Sa0bj3tmDQ584tAs/M1Y89qQ7yFkzf8VZiZ2WVpEis+q7XQ5cwd8oTyxKEDktjas5rc8Gz7GUVLyq+59e9TNZ+c1c4e7tdpWs2c8ideXe9h1We1bXrbm2+peaT89SMP/lkT94v2TMZ9c8az6eWFg16B9f+LlrxunTawZnH57SOe97Kbf9E2zpgfnFH4eGbgtz/j2bhftF2f+ra+z4oy32tzF8D/F+2WF95s9Yy2rLzb/q9tbO0v2nedJo/LLXwk846P3zxf88kvWruEsL+L/GBmyttrYf39oq299Y3howuXZ557/cpk5j+nNX4kdVDHCyMym83vBfT/nHbdLYcnHJVmZg59+/FjNf3OaXfPfXP9qJq5mZWTbID/57T+Zzc/9UbF4+XHNo2tqll0TpvQvMtZd9ZTmbYXPvix5vVzWo+HfeF1NcvKv2nqr8v2ntOuzTk8fljFivIjXavjWPU5Lf22RzxzC5/M3HfD4QTmP691WD18fLZtcOaDTe11WNvzmvvKRnv2hJ8ov3HcV6dr+p3XPi+x2yfIc8tf7D+oqmbseS1h2MexR8NPZSb4j9Zlxee14qrXp2+bNidzSdePFbb2vFbhDce49FXl5al96rO957Vmva74s/n05eVzH1x/rKbqvGYb9VPRumnLymvbIww7w2CyM/wYdgh/o5sG3LVixYoT2oOrm9HzEz16P3VPn7PhLVqT+S1YNd/XCP0a2d/Y/t7ZGS0/Cxfd3jGj8dt/ZHJ/Jku5687wxn2fhtXfKg+5nkvfyEMOLOV39qj7wORPw6NvfvfT1fc34uVZlvILrR59td6n4U9HrH32h1lHy3nYmKV8ygOPD/rgYLiya7Olo9Js/H1mKR+cvnn+kIPhXbNu7N3mUCIfd+X5SPma2bPb2g6Gu3hm/PRLt8O8/xWW8t6jBtz4/IHw4GW3zP7wDZW/H7KUFy1f+XWvA+ElRdsO9r3rCl5eZClXv3v/yPH94UMt1q1o8FATXj7YUj7nm8S75+4Pa2s/eTdpR/J/K8+ylE/55E+92f7w5C9vy2h8dx0+ftVSvnzUpuXb94Vt/Y+NLH+9oYCPdfwvv3zviH3h6jUz2n/YsKGAzznL+F/7fb59X3j43faLW9c04e9XWMqLJx5pXLY3HKucm3Ym18vLQ5byvW8vuyJrb7iw1bln13eoLv9P5UWW8qz7Rqe890n40cwVLze/wyfgYykffHjnq9V7wo1fn/30uiYtBHws5dXNxzib7gn7a7T+/drUFfCxlFf0yw3cuzucNnLHhsXvB8S6sJSHVn7026Jd4atmrRrZb2rT/1Ze+YsFPq3yZ2/eGV60bn67tTel8vIKS3lF0U0f/7IjPLx4tzb0pvc5/oUs5WuPNCxvtCN8clPPw8MWXLHxP5UXWcpvPvf03bd+HP7+4CbbF/uai/VnKd+rZocKt4fdf3xVGN5owM9SXumX5778UfjO62+bUPzVfyxXre2nHov77MPw8CNvluX84Bf4Z4XPC+Pa1mwLd77Zv+q6Zxv8t/LKs5bxl3z/Y5Nt4UX3OIvnf6MK/LSUF+3Ma9F3azhzytVDNnnrXvufykOW8uIG6l/jt4S79G/ad/aUnwV9s5RXN7xw6+Obw66t4+u2XdhYwNdSPrjNp83XbQo/URafsrqo9X8rz7J+f2/BtM8rwufuOT7niVEx1/6nctVSXvlVu8Wnw+Gz7cvu7T9J4AezlLMWsD4+CGfCQml5VfNr/1N55c8W/L1nUf/7ysOODwbdeYe3voC/pbzy+i6jl7wf3v7SPcev7izo4/8qD1nKQ+0+67FlfXjk7W36NitI/G/lRZbywT/O21/9bvjLie0/7vikoF+DLeWqQ3OmvRO+474Ph9wjC/r3v8qzrP1Pe+Jz/a3wt4m/7/ryvpb/rVy1lBeVnemQ/UbYXbZo8n0FSQL+1vL4irYxr4cXP9Zh5rN3tfpv5ZXVlvLU8V93ezl847jPfnxwRvp/K6+wlFdc+eud+S+Ez5ScvarnXy03/qfykLX87/cefbYs/NLfTc6vk89n/qfyIks5mxL71IxV4R/c0wqaFDXb+J/KB1vH96kz7b0nw52f/2Np/4UZYn1Z3/9r7ZqKReGnnz/wa0GDb8v/U7lqLffnNq8sDP+Q9aVPO5K68T+Vs2qN/euf/1FeUWUpnzsp2V+kHW/xzIrcjwR9LbKUFy2983a1WNv/2xHHPYcN+cr6/scZV/RZrl3lvfvK90OCPzBLedaxuQP1kHbb5z/fWxEvCfw4Y3m/9cHXhq/WMi5unDSxjpj/Ikt5xaqkl5at0R5ucvfex6eK8WdZy7/ePXHnK5oz41CvsyPrCfhZyx0V7U6+pj10zcf9usbHCvr/k2V999x3zZNvaE8967t94JUGf7SUV+574fzGt7TPb/rqufu2i/U32FIeerLv3Sfe0RrUH5jpGCX6n2UprzgZc4Ct06786ZkXFzY4zfGTWcqz7hp4X/v3tC97bexyb3wjAZ/Tlv69unB7zgbtx5G/tSgqThT9s5RnlUt3zinXDrxy94f7ehryoaVcjZnZ+aMPtMoeR18fWdFK9O+0lb53Xnw8rF2MKen32VUGfbeWN53xWN1N2llnqz1TqoR8U3nKwr8aTWvx0ibtqhWduj/2goBPyFJeNNs7ZN9mreTt6TvznlEEfbWUFyev/St7izZ3wg2N1rT5kMMny1K+tv3Maxdv1aa8e7H/1JmCvqvW8pIffmy6Tfvo4VE/Hm8vxl95MlLuX/DBTXd8qE1pndly/ieG/GQpHzdpfkL1h9p3gad/XBhvzL+l/Obujyyc+5Fmv27xOP9wQ/+wlLPOp17/YLu2r+WJl/pf6xTwtZb/dvjuuz/WxtaE7sw46xT011JeOS/zp6U7tFGB22++boKgL5UnLPLPPXccardTe+m7V25aeLWQjyss5ZXXdHp0707t3YT+d229QcxvyFLur/7wz7G7tP0tntg24fTPnP4MtpQXH1x77Ru7tavXJv/WvEas3yzr+8dqYm/bo7U9pw9umrCZz49qKWdf//Dq+T1a/GMbspMDO3j7zFK+9q289BWfaG2/9e44vTNNwP+4RX/rO7jT+L3a4pt+qvPV0xcEfbeUDx4yotXWvdqJk5l15qcI+bjIUn4c8XOfll793NDYgFh/gy3lF17ZeW/uPm16ned+273SkD8t5SPvHroivE9bt7HXLT89b/BXS/n62NE9kvZrJ9/v+f43jwr5qPKYBX6HC6o/2K+ds918/R9PC/mmwlI++MB3Pycd0NZnBg48eETMb8hS7v9g8ojcA9r2B35eu3tMvBifpbxt+wdu3XxAu3ej493+16SI9W0pP/5po7dTD2rPVBaf7vCDS4zPUr59/OaF4w9qkz4b4d7TtI2gj9b26z5b+fFBbfWhmLS5qpAfmaU81Mn5WvBT7a6Phk0f94HQ+yuPWvBz+22/PfSpVpU18MxPrwr5psJSPviubzd++ql2OHu1q7knZuP/BwoUhUVKPgEA';
