// sources 2750200684
// Separable subsurface scattering for three.js, by ms_sss.h: `make web` writes this file with examples/engine/shader/ms_sss.glsl
// (SHADER) and the header in WebAssembly (BINARY), which makes kernels and constants.
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
    taps ||= 2 * [1, 4, 8, 12, 16, 23, 29, 47, 65, 90, 115, 150].findIndex(most => Math.min(radius, 150) <= most) + 3;
    const packed = Uint8Array.from(atob(BINARY), c => c.charCodeAt(0));
    const binary = await new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
    const nothing = new Proxy({}, { get: () => () => 52 }); // the header asks for no file
    const { instance } = await WebAssembly.instantiate(binary, { wasi_snapshot_preview1: nothing });
    instance.exports._initialize();
    return new Subsurface(renderer, instance.exports, materials, mmPerUnit, taps, radius);
  }

  constructor(renderer, wasm, materials, mmPerUnit, taps, radius) {
    if (!materials.length || !renderer.getContext().getExtension('EXT_color_buffer_float')) throw new Error('Subsurface: wants a material, and WebGL 2 with float targets');
    Object.assign(this, { renderer, wasm, mmPerUnit, taps, radius, given: materials, lamp: null, count: materials.length });
    this.materials = materials.map(({ reflectance, path }, i) => {
      const numbers = () => new Float64Array(wasm.memory.buffer, wasm.numbers(), 16);
      numbers().set([...reflectance, ...path]);
      this.check(wasm.material(i, taps, radius));
      const [radiusMm, ...rest] = numbers();
      return { radiusMm, reflectance: rest.slice(0, 3), decay: rest.slice(3, 6) };
    });
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

  words(at) {
    const bytes = new Uint8Array(this.wasm.memory.buffer, at);
    return new TextDecoder().decode(bytes.slice(0, bytes.indexOf(0)));
  }

  check(status) { if (status) throw new Error('Subsurface: ' + this.words(this.wasm.message())); }

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
    const { renderer, wasm, uniforms } = this, { x, y } = renderer.getDrawingBufferSize(new THREE.Vector2());
    const target = renderer.getRenderTarget(), color = renderer.getClearColor(new THREE.Color()), alpha = renderer.getClearAlpha();
    for (const t of [this.light, this.between, this.scattered]) t.setSize(x, y);
    if (camera.parent === null) camera.updateMatrixWorld();
    const { elements: m } = camera.projectionMatrix, fov = 360 / Math.PI * Math.atan(1 / m[5]);
    const n = wasm.fill(this.taps, this.count, x, y, fov, this.mmPerUnit, -m[8] * x / 2, -m[9] * y / 2);
    if (!n) this.check(1);
    this.constants.value = new Float32Array(wasm.memory.buffer, wasm.constants(), 4 * n).slice();
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
// that enters above the plane, at an elevation theta, reaches the pixel by a factor (1 + K / 4 sin theta)^4; where the
// surface bends away from the plane there is more of it, by a factor 1 + (1 - flat) (dh/ds)^2 / 2. The sum is divided by
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
    pixels = pixels / sqrt(slope * (slope * (dot(ray, ray) + 1.0) + 2.0 * dot(axis, ray)) + 1.0);
    // The plane's depth a column and a row; in perspective relative to the depth of the texel that is compared with it.
    float2 plane = slopes / focal;
    float mm = FOCAL.x / (PIXELS_PER_MM * DEPTH_SCALE(at)); // of a unit of dz
    float facing = mm / area_of(slopes, ray);
    float3 elevation = ELEVATION(at);
    float least_sine = -1.0 / max(1.0, max(elevation.r, max(elevation.g, elevation.b)));
    // Of the taps before, on both sides: their height below the plane and their distance.
    float2 last_below = zero2;
    float2 last_offset = zero2;
#endif
    axis = axis * aspect * pixels;

    float3 result = own.rgb * TAP(at, 0).rgb;
    float3 weight = TAP(at, 0).rgb;
    float3 lifted = weight; // the weight with the factors of elevation
    for (int k = 1; k < pick(1, MS_SSS_TAPS, wide); k++) {
        float4 tap = TAP(at, (k + 1) / 2);
        float offset = pick(tap.w, -tap.w, k % 2 == 0);
        float2 whole = floor(axis * offset);
        float2 part = axis * offset - whole;
        float4 sum = zero4;
#if SLOPES
        float below = 0.0;
        float elongation = min(SLOPE_SCALE * mm * mm / max(offset * offset, 1e-30), 1e6);
#endif
        for (int i = 0; i < 2 + 2 * MS_SSS_ROTATED; i++) {
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
#if SLOPES
        // The sine of the elevation, without what may be rounding of depths.
        float rounding = own.a * DEPTH_SCALE(at) * 2.3841858e-7 * (2.0 + (abs(axis.x) + abs(axis.y)) * abs(offset));
        below = facing * (below - clamp(below, -rounding, rounding));
        float sine = clamp(below / max(abs(offset), 1e-20), least_sine, 1.0);
        // The area: by the slope between the tap before and this one.
        bool back = offset < 0.0;
        float before = pick(last_below.x, last_below.y, back);
        float gap = abs(offset) - pick(last_offset.x, last_offset.y, back);
        float lower = (below + 0.001 * before) / (sum.a + 0.001);
        float bend = 0.0;
        if (gap > 1e-20 && MIXED(at) < 0.5) { bend = (lower - before) / gap; }
        sum = sum * min(0.5 * SLOPE_SCALE * bend * bend + 1.0, 3.0);
        last_below = pick(float2(lower, last_below.y), float2(last_below.x, lower), back);
        last_offset = pick(float2(abs(offset), last_offset.y), float2(last_offset.x, abs(offset)), back);
#endif
        weight = weight + tap.rgb * sum.a;
#if SLOPES
        float3 lift = one3 + elevation * sine;
        tap = float4(tap.rgb * lift * lift * lift * lift, tap.w);
#endif
        lifted = lifted + tap.rgb * sum.a;
        result = result + tap.rgb * sum.rgb;
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
const BINARY = 'H4sIAAAAAAACA+y9C5hcV3Umel5VdapOVXX1Q62WSo99jl6tbj26ZdNuyY/uY8uyZXMxw829w1wSYsY2MaU2WJbImLilbgeTCDAgjBwk40CpZBKHp2LAUpAJCuMEZQJ3lITETuLMiIRJ9BFnRjYw0SRua9a/1j6Pqq6WJWEH7vdd+2vVPvu59tprr73W2mvvbbxtx12mYRjmw9bKW62pKXPqVntqasq41aF/p8zJWw2DIyg+MzUlAU4y9LeBUsatJhLcKf0fhXNJMBuH7KlJKTgZVTTJZaPm0MhkUn6yqbzBgUkEbIHNmeTonOREVkPgn4yAmaT/KGxxdnOS/rEm5V8GZ3IS8dYUokwE7cnduxHejUJItN9+h207Gccxsrmcmzcco+AVs9mM65mlklsqGx2VDjNfyWbNTsPp6u6ZV+ko9s7v6zW7FyxYsLBqOZa7yMrnK5W87TiLl2SWqsWLfT8IFi+j/5cEixcvWb5sxWK12MmYd5uOk7FNo5x1CZaw/unXebmbctm77rjrXfe8xzK8n3/HO9+x8x1vm3jHL91hmLl3vvuuf3/HPTuMK/K3veudO3a+7Z07dxijubvu2LHjbb9wh7HRvettO++4h3Ibm5y3v2NiwrgynzeN0PTsq64JCz/6dO4OqtE1KtP0n+FtM62pZRwMK9sCe7kEDd+xxpUZTtWUQf/cE05PO1tLhrIRGLFcZStzxHLoxxixqG7fUVZohkb41Q9ScWVX3otqFnpUoFKTOpXjfaLkuIRYc3c2avK4sc3PUEvG9VR5hvKGS2t+VhnKQu0GGqF4RU0WCRC35uco12gtzNV8l4DM2+PWHP8re61hBE64YgvV7Fxfcih7gf4s+vOKJiAza34R2czACr9n3FAyqaVMv1WkT6eGFotUBXrWb1EZykKFTb+gir7tERjGJqMTsG0yKlQfqk0iLYokjPzA2FKykB+Ne9xBIJbhs8IDU7Vyj2HN+s+0PA0J9TO8dzvB4wIeFBq0jaD0taB87bT8d/ac8d5U+E2Mxoc+Dtz+HQ9F+dqp/6safujjEj4n/+Xe+8ZqYPUbNHgVQEv9pa5uMnqKOXSkg1pCOa5sLXWFut3hhdQ7VXpElVRps6H/u60aJB+3B5Wq36lTpx5YF7695BQzXitWGUnrBauWyvqOPa4cIrKAME2gFN4ZdISFiW3h0D2bDCKEMH+z36U6KGtXyfA8Vbi+lEWthsrXCC+ozCi6s1rh6tE81d6Joe6MwV4+fihIA0m1UodT/QAxljZfRv+de8fZ8dvokyuZaq6kETQVMdNFGFLu6BgPdpTz1Fg9LnUmvC3V6Nu3c6uf9S0hJssLs6GpCKPdyvWLBEAROCpGOHJm48jROKLR6qI2K1Qh1dCtiqqbkEulMSOscGhLlTLT7w3UYJQJM90Jd583y25k2XXeLLuQZfK8WSaR5T5kkQweYdagP6cWelurQXe49N2qezsRQ9eNfsUeD4d8ywKBGDeiltBkPBUVU6xvyaRSHTVMOUN1YKQrlJt+LMa8o7rBASp+B+EVM4jqjb+lMHGddVLYqhGdcxYf05cGvEdZ4ABSCMEe1U1Bj+vuVp3oWoffFdfVUaOO/zdDRsWshWvDQfTvxmrcAIamk+KWvjuwCOodlD9/k+Z+qqsWDklOuwbUCAlFBMCDmJBApyaBoCMmgorqJCKoEICUX9eoOLkLKCEaAdY6BEGO6tB0Ki0D6ohJYZqZXjRXPeXF8F7CnKUee+EUOpkP/7t5M/1Gk3ctsucBTJ44sl9EVoAYdFyfyq2hzfsWNZtTVi0cC8dUB2HpnLk9yIfnjC1Vyqy2ViO8+/m4GjMqblFtWwmsfMxKikiwiwia3j/RSj9l7jIn48XplJEsiGbMtw1iLEEmfHlXLTy3aysPnLm9xAvK/ZYsjRlZGnnxImhoHf3DfellUSiRKnKCbPieWviem3lpzY5YfVSMfnqkdCVaWKmGR6QGGpykEmUMWI8fMIPcMd9l2HLXgZW8FbhzvzbHEvFvSlje8+GDrl+wuUOEOmsnhmPAMo4FcxbE2mIrd6M9Sj/5EetyAXIoBeR/eVCAHIqBdNDTPEZ8wHIZup8t2bxYht/Zb9L6W/BLNKjEqimuLMs5zdkSw3KeLlCe4ivnCR89YJ4315t44FR5xHq9dOpG+vFGrM3St/FU335L9+24EXcu61ETDmirTJQUlEOb2AHIqgjJohQ+2FfzS0T6lOapLKcVkFZgkg/yKsNxJOYoq/I+1EkrluUJlvsFBJUC4X4NgkrTAGd+M8XSYv4zUuaNbYbkZAw2KPWUkUhlD1mmN6cIqKndAvsDwUI4YzmMmnB5NrogHsIxB9Er/f3gW/wCVUCL2I1McdRPcDHUS+VIFGMmHpTC/Ux4hK7HOPCWKuEHaCVuV9T4BCKLTYgEWRWYIPMy59xkzoUO996h3r/3w03zjnBrhFSXAahrgasy4OUAqUVSPciC+C5zytoF5YBC92kMnTG3BZbOZ4Gqi4E9an3PlI++Ueu0DqpR63kz4huIIDzKBFC2/NZ4UgRZ/RUQTrFUWSpHs4qAhzz9tYe4odSMYt4hNb0F3IfmPupx/Hwc/4oMQOU5363MZM8/OSyQF4DKH9tou0xYAtnf7WHImsDKRmDFYQYFwcuv+zmpLkv1qFQ9f/9r0sMmoiaBnBZPB3TG9AJ5Pu6yzexOR5y/r0kX+ujHCfdDDq4RTUfMVWD4hw8KDAlztXglCl0MSI7olIbPt/VsJwAB4RmjNlMECNMPrPs9/RsGhRnPQVV7zZqKwodNnTP578xYnPNkKudpg4micoxxHj5OSTTr+o/I5wn5XHRUPvfgM+xhBicx38WYjLBy8bWHOXgrdRuVv5GifkuipolAw7+SnHWEH/0Qh49rwl1Old1I0cTowowyKx8SxsRdNpMpstdyMEHMXdYkcTBb9DULS56BAXiJEHl87Apbgb2BzB0ZriCD+cpxfUH2WCQLj0X0Ug1yG+0Kz5nM9Swp2EcwAsc2b/z1NzW2/NePjjViWbpR+R6AoXns1huHaIyFCk1MyhT56Sqyx6I80rwRgBT7EHQi6CS7o7IPj1rLkc96Aglj+5Cr8tCo1U8YX1NTdhwt+KcUw3syX2CMTDLT2GVPWlMWhSnPcqYfQibRD/SSrDIH7T5SZqlWRfPX4nWchBYTqQVqwwgf9yt/yJg3UkqtAwBtIgGWzqjYUVr+vWO6gmMkG3oajX6p+Io5lE2jHeB7egyzM1ZG/DI0vmIcQ8PjHTtIsQbk4yLKKVRaUuXNj919deGZQ8dpWI4ued8//JujvztWb0RtkEK4+ej4L//NN/e7pC6R1KuKt1fp344qxGDuUYfoBib1GVRDdPSsEj6dfPKIdXJrPV+44bu/1PMitcaBLzxDrQVdh54cpXyeIob+VpJuSdqliO8w6Q3aFWqYcgTeqHVStcGicd3P3/3+IQYY+HerkpPWapW9iSY9VQqAuzVI941Y+3wJP0bgnUUr5SeDzKj1QwS7VFl1NRrU/n7KRbjqOhR0UQxFnEE6jcN3DphA+TX7VGZf0DNqvaTjP0cj5X5UAHH1II1ae3xk/jqzvB4eKqFSjlU9DwfuKAHE0Cq7SvDmj5GQ233MLwNIn0T28FmRgpoapRrCBzn1sKQGed10Pm4abNxVPfu4qZ9r26p9hBZm6nODm3uAK3yutbmMNLeXU7+sm+vRzfW0NJeZ3VzmYWkMyPSL8fRX5UPUUxm0gDjPcUWzvJMgiaeLhTogGH1Ps6H+Ues5xbOOx2wfzT1NqqBARZ06TTnDU6pGc3UN4BTQn0cETRaCjiKYPpOpUQb5NbdgpNq4sDoJdO9Yw89x3YQG7+ELKMe5SELK0bxitdjPoXSR4DkBIHIUeJqpcnP9G//w8s03fnljKnh7lZK/pbxvOBni4qz7mLtAiGBVYEHTprCggGdLf5BlMxzwfVwFOc3xScKr/3djosZ2F4ORybTqaNZL0yxwrh/R0j8h3CnxsI4x9/mYD9PNMWJ9jH2NOYLZYoGJMNOjYAGkyBOKvphdn1YA8Lp/9xckVTAN5aqIPquIDd+rdO2Zh0F3i6TC50gaW0N9GgIuCaMRMrXARBWMWpeL2RCsLSVGZY4lHEzliY1k/AIxpKQHQeZj17lXXzm2LyGIzLGD7diiyjda63oIZkFDFXhhUQTvciVzn2ZOwOvC08+Z1O3RqFcUc/I5M8g8rDsZT57N1LurakQ4JCY8xzNsn5DLCaOmi4bfkYQ2pZGR1nsu/q2m4t9Kij+ri7u6eMKjDO/v7YxNFJSfJJF5EuYrSrs1pH/qMCMbNwV29bobv/vIOMVsJiRXIccUA6ca0NhnY8yRUmBuOxLkVK5eeQaUd1AnER59N0GwGU7taJeNRAI/n6xihSSYWtuKSbBEkNrQRpKqrTC3/Yj+LB+vo5EGRdq/2BpZD8oqe+igZMglFTjVRtxAHA/jaAeJNnVa3HMqr8oo7R4MKlgVi3XioTlV/hStm3Vic52q0lClOtZn1VEjjg6LRgCBLFIXYbZlmevN0N5pFu/kpaYERnQ3BYlVIjiR5lIFxNwZz46PEue4XbFefm8sy6CZJ2heTV++7yGKVOE+pC8iRdLa+cQ+KjHp/appWlOENhNKTWhUHgT+ScF7xPSxhlcg3xCsuS2sBJAWBu1vNMxRMLul2gHjpMkJ0JVBBW5gsqJq3lT1sRqLiBRAe7UQqcwJ1kJD664wW5uABG7CXvNkxiaedZ8Zqa4nrVgxE40L9kZCnkj4T/0a67Rp24nAyug9bqQE9A+86H/9qpHnb9Ai+SmjnfDu6NRpiPbff7C+8d9ds/oP9O8WnVYn+TzKN8py/Rotpz8rYr7Sn2flc7n+3G/yZ7/+/BUR1YeU1QrHonGqnVilso+yghMe+gBnhe3yN0Woh9z/uMTeDVFfgnuB22+KOnAY4eNtNJTxuJOnUh2ZtmblHBqPOjw7rS9KO27VmBbv+Pa3fy8hSju0bwoyVa3eWDWtuj1w9LhxBccdFZWnT2tAz7LKswgDp2POSgZHf+63+NPVn0flM8r8JenySXT5kKD1DML7JbwXtswPS/iwxfpgWIg0oMDGasCmDFvMIgYMf2wFgNYjdPbnH05rxSBA6E0nrUhvsr0nTcuasic11apZe26y2wAzxaBtYHOMJ5qLryDLVItQ7u2sWKvMHSzCgpBh5emrqQy6CmOGynFIZUlvn71R9y9tLCMKlhFs+gUm20dhaYr1vX8xTeLtAo11E08uizLbN5bEmhk6iLQ4MhNHuoi0OTIfR1YQ6XBkZxypEJnhSD+OPG4gNsuxv2fE0dMmonMcfb+ZRDNcrkRbSTRDlpdoJ4lm2AoS7SI6LNL/xFvC6QrxHYN/sMVgeR/O2TlW5iIrkL8tcCNmQ+JJTvhgkBeux9jJqxxj+q8fbmU9FuX/lSg/DY1D37+cKp9tKv/HreUtMe2DJ4K7wnrIlWSIHnKVvaw05rWNuammf5wFSUZz2zxx2zyz4EJkqqNfWGZpVaFKH9DQgXUXuQB224yg/HpYX2A/JR0cpjiHfkpCadyqKoUf/hgIyE1RWjEGOFf5aFSzKkaw0PJFfwQLTH+nDvA2bYEqotWpdEO092LKhhCN1k2YAS6stj30o83mUZff+zA33mQ2p57lSGql2Vz5II+ms1Or2nnKeRxaCsCr/CpTfh6rA4HiDtrP+kEHfk/6Db8iGyXFaAea0SKLWg64cQNs32V5BStM3EL9y6nCO/0s+m/6WXxtlR0W5mbY2IYtoBMS3nJSa6iKPiLNPE/p1dbyKyyAQsuI9QQEM4J0tX3av4KWhTwpB7Kod32Mk8LlNVV5koMsoUmiWYV4nQ97atJJMUoEXbq2AeuUP0orR15yd1JVRYrvoHpoYJVDrTr0a0vrEDVzOthPramuY9BweWcBPXQBtuAS+CjcjXGcoPED96nsYcSWiFw5n8e0JOu7ytEKv7NWeYiz5LBBk+MNGpfmXMSM8t4/F/K8WTNV2mXuzu6C00Zsod37NXNbkItNtHblwzy2pHj0W0PYGOq3eiCGhWcDaAOjlRNMGBRxAhFc5FcjMQKKDA2I3rkw8NGvFUZDLEdepCuYbFRS3lvASRwfg+8QBf7w/bOnb56nJZMH5ZiZNS0dbScqan7LpF4MMUdAT8bNoJxcxNJBWnEipqBU+4c873Lphi02vKOygmKOB6M95g0NkcybCKYXpXDrvCE5NTy8TPbdYVaQeQPc7XnKrKXtfih8fLA16tr76btyhX14GSVrA88DT5nJx1ODSfjRZSwrG+Fzz4F28qy0Pcu5IVrJeDE8MpgxZeWg8tdRGnryKFdES5kul49zv1/npqRC5QP4EOLPDVhnfKLVXD+pdyb4EMVcrkrRRHrY10GiBvUxWD6e8DtoamDT+AmawpR7VAxcqKKf9N3/9OLW7X43hpbSriK13e/2uOGwP1wOiqyEmS1VthLSYEDmRHCeZDkhX73y9S35mo9SfRj7Aetn/D78jPsLVG61/WZ/Ib72mH4Vv7f7i/DzoOkvxu9e01+C30dNfyl+95u+olLW632feNHzBnbnmSPx7M6wRdqUsCJ2cytFPUdRBXDjgIiIQiRjuTfWdH6ItkqC3zEwt5fuk8JLRkkYzQB8tVjSqV9qvgSfpmCv5Fs0yusbMZiqpBHPmydJC8HuMmB3iSpZ0Ln6aUBVsFNDQRxwgZTpAdcDk1V9kkQMp1tCxAm7JFNplP1gOsDzMqoMlpdRFXC8jOqUzGcMCEeFsHCz3jZ19OLhvoFlQlMMN0VwryDTKgYbRrBsxmMLV4G3jF3QYZEk5omaCsI+Im+TIOONCTZ30MRbbRnE9DHrsI1kWePYcwel5OCqZIZ7sxMqUwtsCtRIMuT6iaXG1Zphkat1dE0kzu3PcrRuh6c78ePt7J9EbA9CH5rjjfGgGA7zThuRHbHUiPea3vetDJu32fSf+HEFWZ1DNqV5ia008VORml1i9H4eDlHCW9ckHJTZNf4gdqnsoN2vcsca4IK8hZBkKyrv2CG/SJLUEZqmRQgpt1eDxDLYwN5iv1WsEsMisWYnPDkwSJbeYM4rC4gr3sT77o/xphAcI2zZULUnRGyHEwmkXYx8UdlHbpfNwgKStrD4bUDwyfLmowgBByIYwtsY0M+IPw8wcy9EySxvkdDyUIDsRUz0KPQ0lY33ZrMQNzQmC973batAeIbOH8oGbOCQxFMN4LS1V8Ge+qiqVT42HW/ykmiRCR/sI525Fj7IDnMgN6IEbBNqUe9GkfKInmzlhdbOoFhDhaqI7di9kXVMb8Wbr4+cU1zKgF37xHpG33qH3S9HLjDgvdoMWEYMAVmWKTRUIyHupdj4lmGLUync48cNYnLwKpP1STZk+ZMmZ5yf5C36DHlXvYgNXBrdG5lEszALkFDFW4Z6o1jvxtuaIDG3bfABmNCYQ9nYyaGvZ1VQVuV9EnUVcFpXLF2bO+FG9iij+TGJsnYKo7OZkVHhM0ogz/M+N8UTd2TzKeEe5qVi+z64s/rg/aOTsbDXzIZYaIOyp2+kvU5MYjaJ+SoLnJtNo51KxO48m+uO8dawTB82q9shu6aw1pgBTebrjLwikAdvGSIy3hkXkSG2z329fmDzC3f+7Z6vnP3eNSBvXgRl+/lR3tPA/iyBlH3Sd72kB/ARckcvvCN7L64jzqvYkbAe712074srfXEutC/7Lq4v7qvZl8fa9kU64HrftMzEdpbdFmQ008lca1xhn8jyGiVy3tFsJOZlwL2wRAJUGMvFbfdpWlZsyhsvXzavOE9lPVnpaKnP1ioPS/UQ9r+VDaiGo1ktYZvhFJsLoxpt8DlLh9iyQkKXsjoZQM2lJbLyDZbt4Y8LcyiBbbNSJX4gFm/ZW9SFk+/ntptkWRvebSMEy2wgDQB5goGEes2oOJ7VigI6dTKbGHRezpk5WEQtTRGRp4zlhVNsf5wKp7BnQqybKgGnzShna5W+xmrh+HaCcPxm+tIOz0xSyqlBPSVh3uXSDv2xETgb2juJ2cGH16RCOfiwuLNr004ntNjcwpswqQqLUSNwb6Q4qwqvs9lxy9nUNCvaYPNb2+j+9tE97aNVu+jmGF4654A+k8ILocSKUYKFHdr7bARHdfRJUYgAbYeCzXBZJsk2A5LGiwZC5SB/Zc/XZhptmaT9CyjVf0mlei4JQnXxbSFnktuCkw3ltnRui3NbaN5BjlmotqVBFKYanXjIhRAE60yNPJV+CiiSGI/2dWHhgbJ4px0LtsHIMmjExofUNoSr1epn2mxDyBoP6Zu4/W/DQB8+9QEWtUNrS1Xk9Kj8r/3aLJ0e+6lU8HOQI8Nv7kkVrMwu2KTP8zbMu2rh3VvFJVTZ8LxjubAAdzs+YlHSInMRVufy5of/fOVpb13nNWx+LkcW/fAO9sJClo7Eox1xHUkWNtPBpt3BLN9iUxnLgB0wVOdUGa6lOZgPhyLISVJ6fq9AnnjAZTxRkVPl3izlfgYGA/F/lOL58IAunvg/Fh3YFV1YFV38uNq0qOXFAuTLAsmQfbD6aUdNK3HUhJm1sk/8juA0AKmQJFtsI/VNBG5kTeL4wzap0yqKI2y6bAIIK+AjOZCPSo3Rvo9E5ohYG8hB79QrjevdyBZ43iIQ2rperzVArVl5Gtk6PNlUs3Uaw4y9tKqyO+/nBdTzPu/ksE+bha8S/dpTUWW86DLcmJqPQNlosDQrptks2+NERnFFxmVNzoZffYEYMYndEB8EPJe3KCAXm6ndV6KyEsn3ZSpTCqd38S5Hhyrhp6LlATc0+cgAVHL8X28cqvwZQG/gq7G5b+3mn/kXf8F44xDvnQKnleajGBVCe4cuhKBOdcejmupUla5n43iDesnqJBEGkZQX6RhlbIWUS/D3IOHJL0HMBxo6FdZhQK7MO+I+EosqkdJSppxd1Lku+CuF5i9SDaqTQnGBoLsawEuopChQ2hZQpptYiSmJaY6w8wa2bMPcQPoGZWDLAKXbO4OS1EIQwyOqFnTxpCOsqC69SYSPeqSGfr1BPS2Lyq+4bD3gaZPMU1ZUZdg8FuNo6Nm8U5AZ4Xm/XYTGPwkuZzaRSiQD2yUBCbtLXFFMMRlQDElYfi7lxWaIrAj/W6aZfIzJTITJHGGRBDQmLWyZ24xJOGPZKUx61aBAM480PpKFtpFGL5iE3U1waQE+mmrAnM3YwQAjXWXewOlFTFBl14IcH61SpcZBTRd5ogtsPSoumLIt0HKqUc3ZOVdRctUb9UBIqNiMX0vjl3/hZUFoLivdcVBsRlx/dHqcYEVZkc4a9quBoAg9ZV4kQRpzYqj8ShgSa+EFIEm2rF4BT+U0nipCN6qFPizuftL1bNuuZ6OuZ7nr2aaus6srreAtXTfZ9TQhDrOp60VVbOm6eoWuc4kGixxNXUc7xLHTXTd1lzv0ZipPEIIVJiprtjlxxrPFYZnxRUzffCSefBAmxEClOXnCfU1iUC5zaxJjgCiotcKEDwXFyl+ANercJ2FFi/nmoaa002PEVg6iG7LpDC9J8Eq3lJA46Y2vcdvuHG1XsHHc0var2W4lajeHdnN6fXCE/81CeTHudrG1+cAE18Tqxg1R7cWLwujFVn0RCCteRLWz8EFLxvUmiRZ6pYC8sjnyjWlRk9ng4ehp67MJncapcoDPJns/tJwMLzpm2tBsxxvvKZlFjsU8EnlSMPioN8iQEpNMCxLyMzKdm457xnItxJr4Q9kCSIIW2Gxs1FAAXnLMahpvbyof/oHhZ6h5l8TGfN3HGkdYyVwvDqZRlaqpguv1qkWM/6ByNx/72jN/8V8n/+rqxu3aGQQbtPWEwwReXA12vpuqCjLVABu2tFRUg5baxFTKBzo8bVLSS7ycaxK8er/cT9KhPelMWfctor/O2Eo00GIlOutHCzoPM/Y9saXgsDT7R3OqOta47sooBsmKsfs2UhWbD+FazdpDRllEbak2vs8Sc6ZJq0koLQtZWSgNLsJsg4koLQtFDpaf6aCmUWlql/L/MUbRdYr+ROTeMWgfDkgTpt/HgyCH33oQuImXXxK8HcjPKZd+c/DGoN9skqh3fQX2mQ/Mdsbog7ntlJ+Y27Ixem4dfyzIpU4RW4c22irld3g7aBMaXcsOhPUZ9lfVOxA4hA7hTuVhCEkseGf8dhY8+7QvUNE/Z/1a5dcjsDL91kt+QJrW9yIKyIdTN3BNVP6sH202J9a8QmzNY1eTqio0WfMkssWad9aPrHl5seaZ2pr32VZrnrT7kj8LWJ99C85KAjDLmhityzSG0wFYV1EPZw4arsto7RcRADQAr443BxHViI81mnqznBnjwnsCON8VY/JAFUOpKtKl2QGrCEvvm3XpvQHGsaiJTEqPzlEaGwZc0hTCJfIo8nnET6JXIiSYKSHBL5GazLwQR+1UaeZlc6YYKU/R78yLZiRe3DoW/VJkUJ7xjcp/5pp7FH2Y+iMwWfgozRQtymul9zjLM18wSQlyaEIS0k4pOb5X+ZTML3aRYTQT2Hv9WtBRqWt+XYn8irR7gsnZ4pkTewHzfCbZptrA9hHN0f1cNRV91AcKjwdYQOmzzp8nos/H+PNk9Il29LFEonrGkLTIt0IE9pF21RMGW1qQmHQjEiPtOBDccSZRGpSNqgK2Wzup/4/7OI5dCJ2d2BLqDu9l/Tkwt/k9ykTJeaKE9Ya7t/vzKeztVF4t6AunKfsCYu+9yL6w5tNUCvdUJiiRfmr+Ivqk9WYxycQoboaT2/0l8NPb7i+F0Xy7r+iH6vQB1wnfD/D7tO8vw+9x31+O36d8fwV+j/r+Svx+2fdXqcVhdqvfz6ptBbuGJvuorNZuJTjfzfg8Z+JeDlLzTaSE91vK3kbUYMHKdM7EhynAAZgBZc90BoOzaZcpSQxFW/kouBQhwCHLrQb5mbOLUPRXqPaZz5tqkD6DNTNVAxNIlNLVir7N9DfVYlNJu7UWBUq+mKqoIocKO609AK4jd0qHoac+DWAuX2gXSi3tltLtsti5hUQLW5nwi2bUmLJZZE4QzkjnSAo7zEHvt2TJz2NXPK8pXmJZkO1QPLDBWkXUtU4t8NerPn9Ief4wDe8GvleApkZoqHnROuWpDWreBNFDEulfFk5basM21TvhX66qgO51apHqURuQzx9RCxB1BRftnQCI/qha628MRVYvKjPYRHnDc/Z2JMLcR0wwhCVrU/VIw7fUJlR9pQCjRtUmoqaqPyCe6YTjXqKb4Co2UaxT89SmiYDm5sD/QYhfi1k6QJ1j/ztrpkeOAVDGxUKk2BryCTMDhK6NmjkQU5shMiG+qEwOnBEuCEeN4GolPC/KcXVzDlVjvCvmBtihtgn3RBV5LfUpkMOAKK8BmlpLw3klj1u7Nj01n+rrVfO3sNmPtys6uQamC76SYS2BLDUQ1kgjhd65kYEx78HCVVCsH2Jx4bqcbXwOgqqQ8hsRyDeXBT/jxLxot03VVtBHG71iLxKqYF7N34hRQcImVeClwFOX81BfHQ+TjNAV6nXYqLpMjWBMtCd0PBomjYathfohBgxMUA0jOADEaCKgz40zNAVnXhDM58O9lG1AD4zayIEkOR4YRwYmgj0akatFfzBBXWatqZ1UNXONxtU8GiC6UaK3wbgwhw++wlgMSGYCa5iIZT3z0zz3jyd6cLVoZRTaFNW2EXuYV8vIENrduBm4gvM+KF/rkccPkTZ6O6D9fZxoJEJRcPo55KglPJ3Q9jBO6ptxDwIbCGgzETZya5y4sXUOcKJqmziEynFrxOxqHfa+dZjmGO5JDTfBuVTuCGG0LWXqYJKwm4aJ1pcWKHnMcXUJE+p8qjwavfQQtKkOmLUTkndbalqvemrEK4fwM0RlaQIMqw3grhvC+2HQBq43EB8dpd9huQkhhXka63D+znD+u0kCCuDtM7wNAFTBAml5pX+JczI/NG7AsQMzzP9iiBNBnHgzlU7Shmc6/TXt5EFNVya6LUIPOCv1sUTr2VdIEDxH+c+lysy8gRZnWYBmCnycYFCvP4QIiIKzljBYttvYq66YeRPETxI2cR5Ej4Ossywx7hY0No8Hr5adpXjuoF22Rw5PhC/PXhkcWhmEU9HMMjGznC0sTA5P0JQa5oVxgriSHlBmRY4+AuZoVOTBiWvRuhPVbMY1s+PexuYs2Pesy2GLDam5ZspFNCYcyEi9ER7oqVF/E01rU4tNcB4RuZLWNI6m5oa36XuOVtOwQopDh2kxH2aWTizYo97IsglGHMvJ9STEOv4wLcKQDhaSMECQLNQYGCAidBJRwdaiQlw7Tbfz1UvlbO5VMKvcwHnLOapb8BILG6BB/8rZ5MJLshlzwU0yRKn5/CLkpDMiYNl83Q/zH2bkWJF9DeGAYP71IK0SKTRsfhpQBZhVN2JCX80rGUnzlkf9ulKwfWW6X1TM1OO7CZN6U9QBjCUiRmmW0xBvkLEajhNJoTil+MI5W60GVGaki4X36uM8q2Bczod8v8SxhsoCksDaSOWQTfLk9c08zcmaxqC0k/Q2/aArutagfTpqcnZrK+do7fT5Wzt9ntbOzN3aijlaO3P+1s6cp7Wzc7e2fI7Wzp6/tbPnaW3an7O1ZXO0Nu2ftzVKnrO1PdKatGTGLQW83s5uaQ9aMiWPPbslSo7XOohtcUsV0GhF73WT2jrChzbYhHJyIHHy/VHBzE6FU3w4KvZfssNTvnhy2Fur9CWeHDY7edgp/yUH7BHuHCPW4z4Xt8M9+ytzFPUTZzrhRvZEkGF7FWt+s11w9vpxQ+KYgYYexZ0Mn/NrsxKwC7Jvjvj6HPGH54jf3za+OYbvh2njwrLX134yGW2Vbussw/zJ1t5MSe9jB5nWjma5UouVBxI2cRqZ3WxaPHBQONuKDF1WhuYCCtZbG81cULHDrcUuDMz9lwRm7I/E0MG/a3ZukBJjPzMb+xG6M20Gs2kQeG78tFAcbOuPUU6HC82C9ssgmaOpmhifDzzozoUhKw3CU5da8PilFnz6UgueaFsQKEFBQxc0uKARF+S8huQFWRiteaMrePiKvwkcTa+VLcvE9pmeqSRGgh4cuQdwT2WCPcWk4sgxzmiFHRyToTUVA2NWve9bOTnU7vCml5m6JzdwoqO4OAVEUyGjjTptzppk+Vy4HW0P4xAw1B8cfEz2stzUtpZsMumIdeNagpv4+PghvtP0sstWHa9rbxqrEZBcrfdMXFWo+564uadqtli1kN3/5h0djy/uY/UVe3EcTN3e0FClQ/BRtnEWoYyTpZG+BY+toBj28bqV4WV0tS0IEMGQu5yP90PqJBMWfJePEAa58DmPCzqpba6vFsrAMZygHLnjDZc+E/atydxUJjpNOLQtMKODLWFBpgONWeWgjjqrKT2OS9BgiYnBFl0RikYmtPxsaPKtZi3oz/oF1jTcwAvPzZw7l9te1Vfe6bsdPXaxUx5EU7+UurAi8UiItorGGpW/4X2Osio3DuHf+pNyz4nHVrIOWNyT5jttXn2JS1TYowi23e6aFOhQFbkeBLZgEt9Vh65IVbYE2SjpaSSFJHATE1bFCe5IJerGRNDzROT974XzYYLrOSLnRdhokG1DwPNYW7eFek0ln47qwjTPhl9cJwfuid31U1eyqXurqCtlZVYa6P7nr1W/EocfuLa456vJ/pkOHb6qUflrRlWv6q0fhPNWyF6vPVtZhKd5Cz+rzkY96E1cqiTU+Oa4dibz5wMJJ/ygDxiar3oPEd6DshzBJeQTKXamCLNTC2EqF5lcMzymUonfJxj1K4J0XDzFBnhMsyy7NvFV3PAXo4HqqQULVDfcH2v47KoFC7fSN0VXKQt9LtoKi8ACnNGtBYu30i+lLVFRdB+iu7bSL0X36OiqooxL1EL9Qck9+mOJfCzmjxw2F7oYDj62+BKult7uZ1VxptNfmtgfLG1i9+fR8KChNiOu+Phat06cviH9pxRRwOwi/swVQTDzJl3Uo6JKghWuJTJMRH+UL96xiv6CZYpqUEtnvmJSI8vQzLmXz02l/2beoHy2XnzFnPlnk+vvgWTdg8yRzT/6gzVjnuqClQpXzML7iC0ZWRkeKtTHzoEANj6bfQNclDpGdfcVh9AFnkbJhMrGE4pPIHUhB+/WerBgeqobP91EWw6uQO7CT5d4RxFBi0ZqpajQ4pOb8M1TBZxJkrPWytXqK42TZqbjl4/z2W421Gne+TsLu2R94r/7bPzeJ/6BNv110Z87WYpWr8N7zNTyNVO85Uu/8fJb/5/fGvsNuYhqjFj3mXcgYd5VL4488v9+bCy49Y2/+z8PfwoJpzjh1K6//NHJF3ePLfyjLzw9/o09SDjJCf/2ia7xL629c+xzH378wDf+7Q4kHOeE//MT5cKX//ZNY8+/dX5FbXwrEg5zwhN/8uQtf/jeq8f6r32oePDRG5BQ54RHvrNly4/Kq8a+eN2f/PHP3bMBCXs5oe///vtPftHuGjv+/mc//sSfLELCNCe87xe33vmNFS9d88nBg7/yiQey3I87kfDx29/z3amZ/3ZN9/fX3n/g4y9cg35wgriJ/PE1T4lPBhJOcsKNX3zqkRef+eo1mx4c+psPv+f3kXD8zvTa/qF//Er9n/7gMBIO37n5fXe+/44/33h8jFaUBeLncCTF2x78nW35/1X/n6mbEutBLi7D6zAphN83cIn+Aj6T5Mq1IdofOqudNuNt19g9Krl7LUrsH7+tGn9U6KNOglqOL0BvY9ZJXc6EQ02HuTn6PW3A5zrLvucwaGKth/SQAf91cCIsEjhwBIAU7LqL89kHQbx8HUodl0mknPMaQeYQ94iFg70uLYL5mRdMlZnpmfmB2IJx9wC1XqSGSwRNmbi0B2uuB+pn212H3pnWd00InKF7D3Fwu99yaXrBt4HmHBwb/B5a2MHgKkeCTLxWJOsGLZqVKq0UFdUxQTy+94C/IMYbBmjhAb9K7S2iGuarRUdiwQl1JFKbWlSt/CWvORm1sPlaeR2/mEUJgx3DCjjnT3zkrsDT0FMXtYtk5o6gCBdJeBBRwN0mDpLJAC1JgkuToGI3pWzTkbclMVuJD6WppNu3heYOaifpw22Bt6Ma+Kk7u4I2FSxsroBkISq0LFVoeZtChfTbBNzMilSJlW1KSL2rUrn6Ve5AsJqWRr/R8AfUaloAl1FoUJUOBGsoegV9rFVrKHoVhdbBoWobiWqdRFCkg68HIZMw0cA0ULkG7vwaoqFa2AiGFYU34DSoKnH8ZYqjLpeZAIKcACPXI7VeLgBqPwqpO8zgSO+/Dsc1qOrF7Eq6jrfOL5e5QXoTtXYHb7TRVMUfnm2g0Br5o69hzKTheuNTwQgf5RhWqwjGhlwi2g/pQmUOVf4TT8GROHiwQRlHGkhUJdRQohoa9TqV89Raf5gavEzplonY8Ye2mloeQbkRtHwFtzyiVqhhankYLa+kloeTlq9ItzyirkDzBHYEO7c8THIRRfnDapCRsEG17fpq+WsLwLKk68ubuz4bgLZdH6YoAmCAARiajYFXAsBPAAguCQBXbokCIMQY1OsOBrmGUnVfMYdnd8GGWlr3lzKrJYJ15bSLq5OW1P0l+r0JlhtILiSuhYcSiMKJUpeAtSKyj2MKOqabmI1aKqGCDnUhTkmooEOLIJIsUvNYzpgHTjuP2KK5hSi4Ig84uOwRKVy4B686bPdHxXulj752Q+rE9g2Ar+BMyESwEbGb1EZs4V1JP7trwVXaB8ZF0tU4VbLdv4Y44xjNmLFgHHWPxYbHG/gmpnE+cBEixlBXRv4NfO7+2shj6Do7un8ISwUtV9fx/Q0uHH+Jz43xttJ6YkXjwE0Rj4ZYfHae1NchdhX/9pVTb/8k1udDtH7zzTTalz2j3CNpL79G5aQ+NJtLVgMdmdKagVM9kD1yCbvYej12GYM/sqfQp2AeHpYg6DZzq/N46XdI5eyO3CIZHLmXl3ffKYCh6Z7AGK+/hfvvqs0YyU6+hMbjpaQx04MtGGq/iw/vuyxSkALOivmLpNWmN2FBnVRLAT8FAnC3kBmVdWksu1hgdvl6iD7qwDyqqZtGmDdjsF5Ji4A79m8oRFYCFzt/BSxpvKcOlyqqtEcVtrFHM7HqliqIDptrYNkjybIo8nVINcHQx2BDuK9AXOpmXZ1gNUXYvg4DcZ269ob4zLbIEWHTbZSZiOowPov4hnwI+171iByZUSaXKMiZZTw+xMiNpzGOV9SjictFC1W4r9XrVLWGtYtF/aAQXZw/CjazSGHt13idXRxn0IvoWBF3bN2Ai3LRP0ItG2BSTq18ZYZMHLdl4uA7vo0dNwDFCzBVT4BsvD6ZdRChFgn50fTl4cuArPRNIVdF3iAFdTVBsUjTGBMWiXY/SEgLpy5aY5UQnCMn+3aLkAcIrtGoYOJqrc5Tm6jYRrWJSXIj1vkCZWa6i9pnOjmUEp7Z/a7AFDCmt1kcaECR6vRHhUJBn7sz74PByb4PKlR0reDjfmjA1K3dqJxE/MSDJFDUTGzmZmHLYx8ClxCe28YXnrH7ALtQ+h6PZa6qr5DCfWO5iW1HPhU7qtcfDUotrsKlz7BVRrsKl3ELGw4O+R2qeITYbBkXqZj3HMEFR6TfdyU0TJTv9zAwuCF8nurkhY+P/3UnIjlRaucsE1Usr8Uxh/wS8zDlsqVrHtbzSgM+ArRUEEPN1/xe7lNPRBFlvtQKr8HY26koe0p4KW8IL/aUcNlTIpekwVFM8W1YE5EzQQDzIv3dXKXxvIUNLfy9tUoQ9PCOcF5cx3qwruDnZbF7wPGhx5/fxu+CxH3twzOfKutTXXP5WixI+1qQuNDsa0GMNJ9mpNqZp2+2Jy7sEH0JpRMHLDMNl/kynR7tXdArxxKDPKEYfhu5Vq+KBh+9YrZXBmctgrOW5U2E4gRupOKrgib8hTDrqnnMS3jKetxbCCe98ExNfCVSVWKDNChzpoWtmWK7LzEXOYfLXe3Rd6YIh+0R8aA7ZdXo1utfZMWwYePAKTBiYfnIxpHXjk+U6ONJix55e4anTDm2vvbyqy7UNZvpUJyj8DIaUMdjX9Q0CQAtChEXg1qGpLzqxRxRZfq32o4i+FoYD6MZLKBxfrGNJ00wv42L9QISYvtgj2IiInpagPGPjFUJKc3hgkN0x144VLdvPDnTrejXfHJGmTNvsdg+XKn5cmuHD0JdIISUrNELVV5cc2h059WCTNz7jPReuhUd+2OTMGneW6rwVrH4QHZkxDoiRiUPTclFlNRijz5wrQ+lKFdOK1lgrHq0F9I8Wxj5WHwpYzlTmd0ixfXjsiu+VVhOpfKNGbbsDC2vxZcTm+GJT/yPD03VomN5gRN+8gtHD/HVWN/79j/9QQ6ORh/46teezMnNssrcoYzXWe61zzzyz88XdweZa9We39zx+Wv/9Heffqi0O8j+5g4q+Ds/+OsX3lNTGfrg06DODmXFWaISuoJccwVuc2qeqnDCj3z8uY/axAO58hf/7tjf0keOU97315/8q/ukpWxzyVbAzt8q1/zrv/dnuGFXat73w39+fndNSYc++5cH/myXNJNvLtnSm2xzaq5dbw598JmXdTNm+Odf/tJn7pNmnPDAHx848UvSjPvj9Oaa6B4IJ3z89I/+YlfUjY88/tFHMxfUjWuiSyCc8PO/v+8r70kDpbdVw/s/8u1z90o/sjqhjx2V7OimFT7NZtZGLIe3jTnYzyE8scXnuL1bTCs6Rc1nPb/Du0conhzhD5/1hVj1Mf6TvlT+LT/Qp/nN+DT/CyOey6bXzH3FKXvSvq9AX05yZm4oMb7qO4xs8eeI3imTXXbrLtzpb8jlJzcybBm51Mrka4xwOGL6BSM58m/LkYUs7tqq1CLhkZk2HnXCASv9qtgHj+HlSvdQ6oo2yB9yc9vBA5vXXrfoH/5mZOHYbXwTtMsHxolt8CpC8nX0wI0X1j9F8zYb3ltLok7egpjJOCbLr0VlKWUPc5boEL8XGfy0K2lB5W6gbDhkAdOj7MRg5eItFj7+rjUgvkwZZ21vKclpYbi31N0aH82+WbZ8qb9UmUXrtut3tOH3FdkEhKiye3vgsfSYDc/+h1qbMwCzmX6nqsztUglJIEtcllTnmc+aQRdECCK2mbyFNb0LIoS8yAUuf8qc+XnVQfIt5StGYxH9Qq54d9BN+kKX6oZ/8/O0KkVjE/3ObKVmuc2Q1Z6K6sQiQTo7FgnWDkjG5kXCY/JQZk26ngXeGFFR5yNVZ6N04aIppawrDhn7BX3xW6JwZSKd3Y0+Wa3AEDC0WW0hKMM0IKt7VkRKeSH2+EFWeczw7H62iJextBdEWqDG7gbl/SxT3kwPBe+UoD4ghVvpdsaJTSnQR5A8JJU6mjC03oDjdKIYsXgWHiYoCAbcvBcge3EirpXFsjgi0FoLKX5b5OAcaSxlGpjiBAbhO9IJV1PwYe5c8wzL4rqxbLQox1OHcJFW455t8IETvvWNih1vmCkUW1svCsVnIhS/9JNE8al2KHZaUey8IoqfbUbxqYtCcXiqYdaa1GWKO9FgyPS9dKhB68gXjel6Q2N6+sBPENN7G20w7bZi2m3BtDUL0881Y3pv40IxzRvudsT8zoxFv9Sapmu+03Lm54hh/jxFEnUDe6fbjM3JBnfCjG7akwcbcIFoeKbBbxU6lU9rPxEWLOT4A6ON77JyoiMpHBP5sfAQZ6iSo1+Cd1N4+JShrQE9XLtX+Q3xxGGDQIEyPvsDCzZUoqD3krbUC871HylmPuD+GMX0gZD+1MLBQQsmhmAhcFKlGj4nYgbMXP5iPAYl30vwvRRXsBq+0lSIsI8DEIQRkkLYH0qeMOVLKhTpvsuUT/8uVwH9uyKU6w7xQND8nUSixXdH+jUMT4WtVX8lK+/6m/VtP9qIuXsstgskG99+kdUMWryJ1nf6/aSN8O52TmVhK8Bqs7rGLvQ0+NuCAb5gfP67g0G21eJotredrQCU95y5XWwCPdgV0KW92lZWRdU89m/oUau2qpX6w4ROjqOb1LdulSW9ru06n1ysipmIEQxgEyxg328urb8rrfUXZMlOa/1BF62xrVbUcnjyby3oz11qBRLL6cRKe5NAhRU8EtemK3weZdqCmWepytf8NWoJftaqfmhb/WoxvtapRfhZT3JEdoLnkL2T2QXNZijZ3L083+fvtRzVg7nHbNb3XYHYJY0/aLDlTGv4WZmfsAaEeyr6pEyZ2pbRVBjI847hfLVuq1qvenmg5suo9V76qGHyvGajhrnKo7b8xxu1OYaEYb+IIWFwMCT+hQzJkgsekgVqzVa1VvVpNyMekr5LHxJwr9dsSMA1eUiWvSZDwrBfxJAwOBgS9QpDQmtiP7vu8EWxyQneLCSAlfSD88bQ5oivEjppvPx+zZXBk2nOB3zQBof+Vl2vX+kdZCOuGyVxN+B9Gx49qI/AoVe58IefMfWhAx6i1amIDMuWvKfAC6HErk6FS/U6v4y8pyKdwm852q6AlciKjUBraOFgpWyliBH5WCYWYPLhA+5ETRZcdt/bqdsoR01hR5RQX/MHeNFapW879P0h2VRJ+kxRzX0+3dznB/+qpc9JRIaFPenznj9N+pyEh+rwBLigPg/wyj7Q2ulTrZ1G5XgROem0F7XlD3k453Szv7ap04o31ps6rfhgd6rT+xtNnX7sg1Zzp5OIDMtd0un6e62400l4mDo9fIGdJpnA5x+1tspanSz7vMOR3cY3gTWhY2+jBR1oNsin0ZGPoIBfQH9KdljP7XhVWvBYiVzXRu5wq/wKTjkSM1YnYsZADS8zwbuO6JMkjDWvJGHkWbLIJ5LFOnBH+chohlhihgi22MFscdkFyxcdzBaXvVbyRferIF9sEPniMrUe8sV6kS8uF/nidZckX4zg2GRb+WJElS5MvmgaxvPKF5dvVa+L5Qseu96msRu6+LHTUsZrM3axlNH9k5AyMnNKGUMXJmVc6MAsUBu2qstiKWNdInJEAzN88QOjZY3XZmBiWaP7JyFrZOaUNYZfSdYYhGY/qPrVeqgHq0nkWB3twoT37/atlEdaEhxK3SjXxoO7y6/I9cKJf2OJXwCxwqXvDrI1ld3BG5RZ5gR8eWly8uGxtK9fNRjevODIr+74j59+x5h4sG1+5hCeYF09rn3Jhjd/9jP47y/HKv+Fz2ngrq8bvntmrLF59c9+5Bs/6v/c13mVGJZKT70LBZthG6J1ACyGARlKATKUBmSkGZCRFCAjAGTkQgAZ8YhERhJQZnqIkgMTlmCiEyKYF0z6l4jQN4j0fPPggWCYRn0YD2yTmlzxifrwHJG8HCrjdJ5h+rHGBszgp2JswGX+/7FpGhvwg5+KsQGj+f/o2OCY9EZ7SDnJ+Ycvl3PmfcWpLM6LTRanrEm5G1wb5viek9mj5sihJjb8SVB+w+iZTzNlTuPDjPIwIB+IjK7clqNmeC9bn0TzC3K4E0FPTpLy03FyOLVfHvPmA0Ql8S8isd/1O0Kn6QhYEkz79STBniQ4Lwn2hqY/nx1/LFXmXbs+VfQX8HJUUqIDQL892TDVApz0C+AIjZgTFNPXFHOcYrJxTHJxRL0eUIbeetArN2x4Ub0UO68ezJPXTQup2J560MO3kvI7T1Fsdz3oxkV9uCc4ie2qB124gA8uIklsZz3o3Gj3RxtLffjpUwvwg4NUVogDxEwaJbjIlWg17uBLmvGTIXrqgN9cB/J34KgcVtOCYnfHvGJHFlexBpTDTy46szMfVDc//OVYkTdZF/OrFIAm6i+iANRwOPlDx+8QHb8iOn4xIZolCdEsTYhGJUTjJ0QTJESzLCGa5ZpoVmiiWfnqEAu2jrW3jcEn2uC+LqPvL5SHBlhTzUXvdHqE+AxhfbGYLQbZwr4Aos4D0aUHlurDZQzxd1YuT8CblikdcCFpogtpKKGBYiz38D168SZmDppoLvKQ7OALTXmzN7E1WPQNPZP3LWIVM8vn32pRI/5CT9M321ygtBb54Kvux6JZ/Xh0tLkf8Xfcj3D/UKTPJsFV1J9Vl9SfUy39QZ3n6dMqasfTs5jtR7P6VJ3Vpy+fNpo7lUQkvTp8yoi7lYT7qV/9l9SvyB4Q9wuVnqdj/dQQnIxW8D37tGzy9O9Xy8SvgR9gPhj0q37CgVqu9PcqtYrGGdbM2gVwq0Bl23ArPxWbcCuVik241dJUbMKtlqRiI26lzwFqjwZ51ELNF0OhuFeBwfjz2a+NBPvonhobPpC4q+bQpwToecQGTiu+IPtTAnAPxZyJYwBsN84+xzEAtAsvJvtRDIDspJg9cUy/95/7MwN4RTn9bPteM77Qmdc/fRuIfoeG3U8sHki4V4RPnTXALy2QrI9r9B87YcgdS3te4L0wM6y/X29zPoubw3CVyplnjRpfFPQ4G5/M8Hg/+LIp3izwzNiPMp0UOIkyOFtwGmW6UR0f9SS2248dNr7CsVeuq5qv91v7wIkXEMVSEpwFAWuVrzMjfm3zw5GL5X5lYsu4B5NZMnIpZfk+TahAHpQMjdcz7+uTl/fYWYE+l9HH/MjXdZmyaVYsJPY8zzf4NC0N1S+IEkpD9K5I/8QlW32QNAx2MuHkpiSF2WXgpTuShJaBPJap5ejWcj21FoipbRl7vPbQ7x6aUlwRPsx7+Dup0lO9VKGjerV7YN82qrAH85iy4W1yCsJXsE+ApoIbGWQ46RjRCrsMe7TLtHemoGFpOxyg/0sof7fgAHvX50HDq4MDPPLSlUZD1wWjoStBw6JLQcPcSFhMuTv/NZGAZ3cqaSxULhgLlQQL1YvEgkliSMFfSQvOKpIv+1XJX03y5oDq8AfxLKpwDLUCXHsNuxjBAXXto8G6Fg/3dZ/xjcTDXV4Sl6l2Y7CerwZdd5DYMElEE4GhgrRLsoLwlLrybd3BhlpXD9bRP/46Gg8jnrTBEFqa6WGz+hyTd/B8k5c0lhdJOmZngDPJVA42zB5DybqhOetFjWhgxJNbrZk1vykq3ZCRaghjbKTG2MAYD/AgTrDHgWLzmC8X2EPWV+saDDfbmPp4sPvkESGjmeSNaObPhcZo/q+OSZ+RMycumxE0Fxr7fgw04g5LI+YPESa7Lh2T/QkmF73GmAQTWfXTg0kIbUbMZCJUVi4dlSsTVFYvEZUkI2a2lPhxOg7ZnlqJPCvVKvZaUf346Ver8bNaDeBnQA3iZ5D4EkkXK6isp9anFvih863uvoAIpUawGQzDUV+e3R2G7z4H4evKzKElC6TmJFs8AnvPPwIWJUFwVgHkYaMWDUlUudRmyUhwRoNb4Ubb8nyf2n5gtgAgqNewaYw/MJt6L0ACyEdD2YqAl/5DLY2ns++qMXW3ZvvhL1wKnlhjMpqw1VdLsYJmhBkphPW9AsIi+QA3F2jUJYukhlkvkg9cgqyQ+8mg67DM6TnwRYmXjrBqjLDsxSKs5dVoFz9wD3egUfj48QlWvHOf8q1wmnSSVZFO0qt1ktWRTrIm0i/WR/rFUKRfZCL9oqr1i/lav1gk+sUK0S/6tX5hyD35BpKU1i8C0S+Wav3C1PrFAnh5iI6xgXSLlWxlkVm0ISaL/mZuo4g0Fr3GusRAWpeYnxYf57cXH1fwQK9ID/T8H1+XaIsD9H8BlobXWIweaNElMmk0ZC4YDZkEDUtfbTTgqNfQvyYaoE2sT+Nh/QXjYX2Ch+DVxEM0JVb+Ky/AA00L8OAlLcBt0LTyVViAzztt1vwrrygDbRbgwUtdgNsgbGm8nqy+tAX4lSZY708GYc1L8OAlL8FtUBbEKFt10UvwKkC8SvXip5fEZwdL6Br8rCEJ24GEPYhFcDCxVoZ747P0n87a1pQ5mYmMidPJPWPyGJZcdcVHtc4a+hneIt/0zy/bn9WO9Qu9Ng+Z4VJdPNR1cNZDZo5y8MSuFeaUVcUpOpzHoKgit8Y30fdbFXmEuchPNA/a96YeAvv3yJc+THBvci9CVoBTduVxvpfQ4vN3J/1adB2EPi4YcN9yuHBh//9ylBU9p4UXhhGj39Jy+Vm5El7PQn/wetbvt3l4zLoLe1Lhqd+35DaYM3ycIvVkq9wjrdzKb8VQZeTJL0+yC3JxByp1vWSjwKCt8NWHzbnKZyQZzXGeniBzTwmvCboK/n2MsF3bq1IqL+W8ymellIeRNEn+wphy0/x6tCmXjMDx67Rdo+yfQ3ZuQqoOkyc28SRe5fNMNXIzNort/RJ10w6n+N4Ti62w2Ehseh0Qy5VQy+ND0b0WdvNJEGwoBvnwBGGvOSEfHkacftIUkwCDcHgIp5rxMm4gh3g8Au0L+o0sXCdiVL7IX5BJMZQf169kMfaaIvnZ6ZYhBbocmgrRZd6W9yJOSdvxC+U0SazoSlNs9fG9E0U8H8p8oHXjepyXdiskiVU5R/mIC2pvPUHTF+Wrm7PqwOkaTjs+O60Sldtv1sAx+qSFo/Kl5ItEbD5ae0Q+f/ODBPyINYRSezh4NwV/W4JvnP1eqkIbeO3881JwL97EfkLChxGelqInTXkx2D2Kp8gJHbO7maBDALxbXsu1aNEJs8qsfIjnR0YfHJ2CCf9+K/RxTTOxE/ZqM+TQuc13yin7JuYa5nZ+jQjv3i3HDBmx8E4X+M8TH5HDPqrW9JYiFAj91KV+VPmNcmV8E5sxwjubyJnj0hFvK3FtnIt39rLNF/bK5/QD6+SN91xzaq45FTWnHkbkF+DdmLfxG44WXuiLZDQcqlU5OTWVxU4Tdxyv5EFHAs/50ke581HP8UCorCXp5yvhQIGaz8Q0n/G+cGVu0RR8NJxJ+75Schi63p/sNzH18728PDkJ16eJkckcJxiw4WTiiLRAJVs0chEg3ylMahkzfllg63yqOActDdf74iaEfHgvyflH5K4Lkpcj5jB9nO+1zTMP0Mln9GnYTFVHsJtABrudGSX7nXKjihU9mh2duY5L4Mw1t+bJBhpOBYb2zfKSMbuW8LF0mlvM/mg2smOCxftiRXSBfRlIVuB9MktOiHYgocG3cnG/O+X6LUdfv9UtT+D0aGU1jyth58FBG/tkeXm8Li8Xd5GOmufrExeoHjwlt5DQFF15aKlFxBdJcljM58/1sd0l8rGF31jfvT1Yws9mxdd65bYz4+YnosPyVvYOvZf9xeFTITeuzD7oFyzVl6eQihMFb02Cb0yC40nw8FQSrqfCe1PhaVMooCLWhHvlNDQGI4OB65Bt6rnASt/oIk/G6sullugbZJdsIzrtUEuSSloXG7el7GIeUcXItXcGfi18FqckgqZywjyUTxKZ3BrXtPSppryE2OXMfcDB2Ky5kgqv0PcTUSu45GCvOJCsQgr6vQoyaj/lIspwsUmznUS8FXBYGeAtG4C9XB9PWULdWixdBOxE+qvUErUyeukmWIPzryYfWBkIbRGtc6qf0ZEhDNwpOz9qbV2tqXNujr67ffS9baNnxeXRAbjswFAkvgdyk0weY7ua+/i/2bu22DjO67y7s5cZzt54k0gtRZ4ZUSYpkpJiy7JkyabWkSzJKVqkD0VeC7tuQTFAfOkFsRrqIS2MNkD1ECBSEcRLMkHVoCmUXiK3aGG1TzbqogbiBwcoCqEtCgcJECtuAKO12p7vnPPPzJJLibUp1Slsg5rdf2b/+S/n/p8LI/OsZb+hGWRm2qQnIxKuTjLN0n3qVTuJNRpnwZrvj6PzcYmbFZsT0ZQSTFC6yVQqc7KZonq9ksvnC16p6EtEyJlaBVtC1NYQICaiV0U8mKxWQtkspOoqp80IDS3G9wH3yvici2cSjJ4VjI7L8DYGdZtK3Xr2U8uKUI+1GYF5uzM+M9GB9MG59OM81k2gJnPb8H2G9xUlvqigQN6eluO3wIKQmpZECBXFprWs2tWkbcQKrV1JWprW0rGWuQ7/x7oFgwyv/Tg2dNw5k5SVvAr0MeTxVo1bYAzv5aJ1hSiGTG/cVUUTGWkUS2aONp+7NpV5mcr8xql8gInMo6OuiTABe1GSfhygOb6/KuecvLkMEVN0n+CAwB0z4DLtz0oFqFmzn4G1Wpb4fuarL38FnPdVp4ChHEE7//zhwvtwLRk7XHgPVxa//t0Xei/+j/JLsIypRWUczW/bjze5UWURoHxNwChgDXOaxynntDa0QyfWTv7+Zfz3Fwud+IBmfedJ70/TKNr91xY6dGDNHtivcfSOB0k6wflbQ9FBmsOBmhyr3d8jpGBCR8gUWxhXoCShF9UvgujwjA7S/cxJ/ivfOy3Hj3HY9W7ehQqg5DX3PdE7YmACYohSGEZwTdikCyaBUxJbjm9lgAAaZHDd3KSCw3AKMmmlGdzX5JTMskNVcEGERlfKpt67Ex0Qg7V7L7jRuEEDKL8sceFsPO0Y/WyW0ZcgPmiZ2SBxDpTEB5KTBj2Oa1aaCnmWgkrypDGnj3Kaov/WEC9WlLcvZq7EKgpibe1hwqyNGSRnBl9IufyMmjaFy9u4KkiBY3U87/ACbNXs47WiXM9hKjRrDMXtlnEYES0llEM7yOzJOgZTLYbiuUdMpqQTaCk5HszVS3ixuiOjmbS5s665qc0XM834fsG+X58CA1/ipaC9S3Qf8+k4xhCjB1xFpzejOEgzGD3ArOiBFgXOVnEI+6iNZq44hHU8JOaKSSC0R8w3L0zz9dDhwjtTTnna11PimHHWrn3gn1PMSUTw2KeCxz4IHmW+sOAxiW8ieESbCh4zTCGnegkekx8RwaOsBQIzgkf5fyV4TKngEangsa+34DHjBA+mHG242FSfaPG/U0+0oj10iGJ584PZnYgO095r0bwYU/bCivhr8cw52vPZONZNw4la9BDfYPSFh+wRlkJmzkVH6bB4u7cL/C1+ODomG3KE9izF+9AS8BwmfjUOGGGfc7uUFVbBiY/xFKZExUY0M3cwxzNAmWNk9sSvYcF6zra0g3vaaVcz94OoVJGkv+AkaSFldEQwWxb0CD20FB1vw5H64WjSQ7LtiI5rjlorzBPx2NePPFurZI6OSjVtZMIGGWVIXex6GPjku/SsupE2NZqUmY4nv5ZJzjLB4N/OLtLsc7Tuh+457b73IzZtUbLGZdrTNIO0idPYsmlJm0iTtAf4E1F8Wk5J8zgllTvHcOcYr4zcOYI7RzTVIqPvPO25tnbUe28KPrGHC69PGVEbpQeNf/PUYj1brYpRmpciXoI0+Py5uARdoUalRYk6446PKdAwGPFD8SQ+MyZTADgCZMXH0fQwfy48g8SVR+g4ZvVIVkt9VLVUZIOOswLtHO1j1D7OJOMI40KZqepMNMsPVeJAOZ4fT4OI+Lzcy8ChOaHFAByjwuPYDayg5K0FtRBYlLA7Vz254yS6jhP2FPIE46dRQGTapbESYjrXpZY9JDJO4WytINaLR1idruXlY5nvPCp0ILBkoRsDUSakDKupm0nW20wr9Ww92LP1ek5xxWSC88p4CgnSTDkHurk1nuBDQkL3aO4iiFATGv2iU8htmMKETaJ7wBMWVdk94A2tB3u29hxwiFy/AS1IHlxGlsjR1AVjtz0GklW28WugQAAlvcbPTy6merrt/erRjVp61bvjmzfZxQ82kiBLM3sNKBQUPycozpeI9tFRYF8ZlzLv5jK8D6a0WESInXxCYNH7LDOEoJb4VO6Vyrbpuca8+E4B4Up2f5nH9XPdGiAzWH3svFlxslgZ6hQS3tbFRrtY7Tp2rBrf7ZlpSZc/SJcq04H8ev0qUVqCa24lnsdSzqfhbKcYHVVc2KuwvneD/UrE2llFgoxwW0qEWzEjUp/bOUO8d/OJ+SqDju+mmCDDLCpwmxaAGc5ihrvFeNj2n1UpZ32vWfWVmTcsT9jIZwFRexmisFyl7mWShWLc7gVKmd4gS8ybaVLkQh7MIU13KUalkpg2cOstERmLJjIeSoVGTXfJIi1ccU3e+KpIfjTojvY8S7QOc5ZTt3Oznh/PrcXzGZu30QEjS6znwJwOe8WcZaXzpcQe6xQz3g1Iuw854bf4hgq/xXdM92i/fWm9druXVVkwOoLMKmes0ypE2gj8RBf93kJHFU1mjVCC5zZoq6+lT7g3pkpWovymsChwO7fCJMeblV/Mcs9PxUFLVAD8juEPws6zmO7+pE0brJ4Zq372aX/IrLtI5nfU/BOxm+/HsYUQ92yrGMcLWawQGwhwoD9D71V9NrNtksO7oh0iRoUZa93sJZ9DpbIJGnclnw+yCq0VBZIU2BnCjNsuodqPM6rynfS2EcWMimYXN/F/Aq9y3epkg3Vdo2JBQP2oWOCFfA2gtSlyQGIJ7Gclp7EZF+AFlTD8ThfKGDcyvc0Tb4KAsiaMC7/QZcI4cQcTxoluEwZU67tguBj/f264oAMSOJAxXqyzW9zGZDH90TdZTG+HySK/nSYLVKmTHMp2AkQ1Eb490c3jQEuHiqr+oqT8aXYRofSMTnYsUJregwqZ1LnLRM5hHvysMbR7J3Ki+gA2YFaP9JA0fmvSZoby5I3ylGi2iy1vLnJC+Rfb7qzo+0xhseBnbEBjbak7PYnCj+Kp0KI+uSK7Lq4hSsocxIFhTa41qsu1Tg24pDaoiUtTivxEY9J3VIbzO0wnsEurq4NkJJ1257WT4d+EpUDKYpTO55dtd/IJM/lFAdNi6miCbKeHC76xETEK+ao9liXFsNfWYjYVgR09g4UbB2oBSBEAHJzifLQAfOWP5bMtrRjtn7Fzt4oUG7XYUpyt+teO2nGZrzCGUgPypsDeqlV8gji0Et84BOSFssTEuj01ybMi6ZD5iQZ2NhuIr0fH7mA3GtCSAzyDeBAn7pkga1SEzZOUyRumwaf58yANr/Czwytr0RCvePJsypPrNPhk7Lf4x3KWXEGi5q4+a9bdL0nlncEV/qeO7pBWYQihpqh9Z74rWk+e+rG2DTlq1BzA9XVRV/VvilBrUVcl1JAo2iG2O83QLuAdjTr0KplpG3youQ0XawvTuqlldbG24pU4hSq1L/7eslU9Lkm68Milgr70lWWRwobWDW/om5GXDo85eSjiDYbnZYZXkkzjXnZ0JcuInjwh+O2LwcnQCd5K5VvVF5Cp4vNfXHBXzSuLdDJIK/ufV17+6y//49f+dkH8hMrmC6Qg1aTCqWhH+0pT1AH1UcLBXR5Hd7SjnWv+qfM4aRcaSAlYbh9v/pmZVDBx4IaXJpkvqdStcq5lmRdg8ETgLuEH713pj2Hu81rkuzTzBP8gAev2deTwBfjKJ529w8KGuUjAfeDgkshBsFXiVk1vyQ8BLX3OTYJKcTWxvIayeRmYNIWyPOtd8uN+qgITsprlEBPAwSc1mX5NHNL6upTc1ESIQykv7Ooa3Xb8eEAhfgAQP0D9CvEom4KuMj0g0FqWbrN7VDsFktxkNl+LPHPN8WOARgy8x5vW4zHYYlx3KFzHCOrdKCyzHNBZZn/puYTmAqXoA7OoYxZ1GkhnwQjCesqv61lfv43UA5x6QuyqqthVqeEwK8BetHNSL4zH7twkGdFA6ysuQUrG/aYU/lPgaflsrXyQut4VGaa/ZexZEySX28uscsOHxsDXN/CVSgkCSdeSoqNa6+v6T+pMQl0/CtpCgy9eai4+Jgj0O3/8D+qP177AbbeqL4//1g8+/fLXFtw17lNuqgjm1nZZsktKXQDFmyT3/DvLQiAgKCaMZxdVo7B7nE6VwzhtgORnR8QjRKV0fjmPy71+/Tsp3NLLtBz7v9zLl/3g7r6sC1C2/pbsO/gN4h56T7Z2+/dv+zdpG3ei93KfUqk/2w9cBgqM6X+euF+j/BtLPQnr8VPWEzjWI4a3QFiPjx+A9QQoFMTimGM9XWSjkrC8wGhGwIJh+Yy4uLXzTzybDgH95uJMgZXAWZwa0mcX+1N7U4DfYAw5HkMuw/7aufBWqZBfLmSqqpSdH+EGiHltAZlPPFtCkV15WN/ohs2Ksp/pxGPSgLKk+ePd9vhRpXvDD8mGf3fzVyT9UmVLHaZQvk0dJvaI7erwUII129ThLz+N//5tu9fw+9vX4d+/jv9+uG0d3qGbnp1oWQcLtvjuDh/ZzuTvBS9bYOiin+CCKmQugQvrSV2FosW672txnTxq5/HIPmMlCv3sg1L7tk8KVIi6KSUf4Ka67lSgRmULp/H1NODy+hLPNxao0lqVOrgaFQZFDg9mmpoSb2tVSddlGAqVYFas8m1eh7OIw1PVDe7wRqQIq3WiIJRcy6ySyvK+ZvQYfsUsdoF0HS4UE+uFZpKAj7FYLCpJjY+c2Zd0+dTLopbrYcarW81QHq5EBslaljZ7ECvYo/5co0cpoibVb1VR8BB/vUoR5eBX2yB57nYli3I6MH6qyHeK6yyBdVetMz2Ed5tR1WqdsIFtoXbSHYYh8RRacRaVRKqLAgwS+QcV3FffavM5r2SK64oZRKvG4NK+mLJTUeoQtMOXGU9UUd7iWzmofKb4VaXWCz+Di1h6Qn1qBkVIpMKO5SWpaXSBxLsUr0lVvajWzqNoMGCgBAPAJT/qTzIGcd9XzENe6rvkRS/OwRW936jUHy6wCoBSwwPkrdIAw+pajJpP/U+2VDXIrX9UgHHz561Cn2FShbTSLA7VeKpaL1UsKLcbAM8MHZp+VXTFRgeFksBeI2AaUN+1VRpcy2bI7E8Qz8wlFWc9zKEWMTLEaJ3WmhRHtzqtyKuI6Go9CIyQ5lHEAIBBeVGpSeQlZZeTt7AuNqDJ6TL0ygsdWDKeXoJ7J5JfXevwItXIW0HisZxzJUJDapHhb0+11pRWQIGFQiMOApml8hxpFnrSR8XHpc6spPnSStkueeSQm/mwEuACFZ/VosNXmvwwACrawctRpWHYT+NQNfGdqon3oGSlVoRYrnBRDTZG82BNvJakFL3xSicVHPkHA0mC0RsLHUCm2TlTyUfIuwAu/u34nVRiQLJ+j4JV3vh+VmElpQEDhgIHpfkGv7ES17pjUXay8jzYQervkTXaaSk9QgvQEGBwtZM1QRB/6GimoCD7fi8zTBESASRU/NmaOO4Ct9B114C7hohEaPz3VGvDAHnPUKtm0IZYcUN0EFmknOENFU4LsxCtXEuqicW2T6qlx8M0ZHr3MLKcbbKxkmtg6ztrdq2Pt/Yjs7Uv3txsa8XqufWtNRvlx1v7UdhayNRM4U2o/sluv+KEaqnhmX9BLanFOO9oecF508KOa6XAQbVhpZazRnFsLcFpJiMa++byj1MHMbVmDJ9VCU70zsa1rNBdlbIgapMtmfNECaGt9SRWASeKcWNWMtlfTdo0VqGexCqYPZJbXHxBVZxwqtSArV4SVVqZRhTfXowazp21KDUj5fRZstqXLPGEjMN6kipgYmnPFM9raLBanyxVrctMKtn9s8ch2nJ3JtqUiTZ7TBTWYhHTtjjRJrrZONGCgFSBAbfKz6yS35GcNTheonyaN5hBomDx4uZnhay7GejQINJXV/Kaj4ZhJ1z3BEbV25COif/G4ub3Pnebe7+y6T1fls53p9ah1BKM67p6Eu2OYgeUs8qVpduNz9eOZPEKWLxCJjiHJTgggN+N57lZqf+Xk1zEK+SvvRRVsSQNrXSXRbyKIl6g+qnY0UummBWwkgM4KXmGlVMtcRUgH09ZzhgRrZuk+y477KaifqIB1nsq5g4wmDigJI4TccitYXcr9Ww92LNVkw9ZHHodx9B1Ex5rehpYMJis4aCp9xi6FpT6cIBPfaJAMXc5x/1W7DBbZ1FVX5fM8Vjm1xWB5QojL69cQ8A3lHVIVltkmKI66sLaeBdJ3NvXcxtR/0ba6HD/rbTJIf8brumDk7nrryxvkc7d2BY6tx2z/eC0bsNs7wmxe++nktjduCvETgwP4h3pantuTvIECT+mefeK5olwf29o3qWbPajAxZsbqMCLNzdQgQs3PzTNg6fG1mieVPf90DRvO2b7wWnehtneE5p3ZfWnkebJfm8/zXs7oXlvbKR56xDQ6J1kXQx60Lua0jvP6F0uQ+/6etK7PqN3tf8reud10ztvq/QuQAEZc8bNbQu9C8PvVStO7S0uV87nf9OdJBWTBF5WA5s51WU7L4nK6clSxWViOW9+X3EAAiF8RzJDBc7oDLRkZR1EWx1y+Kb4RPVlnqBQ8jxFfXAiQPQE9eFkpoTuSzA9m7cMT6Jd0MiXolSNWKQADya5QwXbAk3YQmU1ylaRQwZHSGLSxuMyerh/fcnXygQdybiCSIWowRNv8oyaeHwZZQnq/K4m3oVkX+pbPoBJZKbXPCV7UWaqUYoH4bjTbCG5FE/QX4T3YXuZBlvXVqmxioRsKOCh3pI1nmN1SX2xfHiVgrWI56QnvozeomyuZHErie8PNqWIpaieVhPHl0akro3sc2AnJFQ9bYnbGcBOqZ9g5XH+0mxLJpmSizDdbIksNqdJSUDBK53knHotdpg+cmI1+dSBS+TJp93Brh2gvr/QiYbJPf/GK85F3uPnd3D7Dz8N76Bvc/sjfSg49c/8/E5Yy/t5U6IBXohBLy1lJYYtW7o8DQoEvWW10ZF81c88yavZR/1Y0bQxTE4nbLMztygvpXw94RaW/kE9mEFW1eh1GTtIYScKHaplvLgwIDmazGbgiAtU6Fhpncq649hGF+dsyACaNgDLNsEsXAbQ6PD9ja9EgXUGH34xQO1NpPAqCKw4y5cDixEm97t47Ks0utbhtekCE+5GOmCI/eplHIvJysZe4l9o4PdHuMloCuhTj7cG7qRT2KV5cAUn0lZQ38bJ8T94+8z+//7RQubjk614tItHZH5DYa877yzQ6ArfLNDoS9b0rzih11AL59zDwPR1lC5bu7HQ6fB2rUVCVV697JZHBtTFnIbTFzR6fXyytcLUc0grn63SDoDBzo5UGyq1/wod7/pO3NKuea1TNxTQtfDk53O/+/5/RN9fWEv7zsyvFY2gmzfRTYs3amTtO1/Gig8Iwg9Qv1z7eVd40wbV6Q8nWnJ8L8CWibQKQWFevpx3J3EpxN1YEIhDPmQ5ISviqB1etkrXMnLDe7ymgLPzixtu3XhllUERrw+VmF25jDxhF4vOonrjdN+QOJIXXsBf/vxe+del/6pl3HaUkQgg+ksxaNeuJclf0GcZ1SzVYpj6B/W189THa+RSGFTVUQGNlsKgGiZlrAoimzJ/NM9vRUHNXJDPZC6I64qzkaaIApY1zXdYsozhAFaSblWSpFuVbNKtEHeHQeafiXaI/OtDHNlJdanHVkgp0InM/sejLUaYUZ66ZuGSYe+U82aW5lWgHGPm06RRHDpwY5PCxcWzkAN2sdCzu4c3AfLMTCRxXTQcEY0gxZjk+Bqj3T2ycUXJ+fwJd41jGu91as+ttVy+4OFbsVSu4NqmW3+X539ez9/6ecgwP8p3S0RjCJjZjXh19LnRcWGrfVrIjes2hAwbcu+EIIfx3k4M4zQBuWCCCE4MlA35qNIEtQBrWNkey7JxUT7UktR55zLDR/zIGPkWPzImbKlfRjWWjmpXD6AZa62+JJ05gW8M0aEQ82gMvgdQerjnXbSr81K0R7NCLcYTPfsK0dcI7pPrbQLSyh5eLj/zgiZWGAEUvJAhHA1QUdoy4o3QIBLKFnBhmtyW0k+jaYCA4E0/31f8AjtvpcgxwchBPZGjBdQoUEsTJmexQ5CC8eOsYEYrixnxKCoP2wMhpPOBszyYwqdcayjJltE2gjYakRrFuwWbol7YxOLDICMPT5h/TVJYcZSiuw4tYxIUvDtFpJv5FO6bCveyK6NtKc423juab5wZBsP9ILhFv8Bbv8IbgAT1loluB2YTCmZapaNgMLciQBGCCCKOBEFG8ZjCwgRqKTKukeS8azEQ8COtttRPDO3grWddznEJlkOFObKPdq21Idkf5D02BWRS/OGgpQHnsR7ynSzgZAwxSfZzD0VPi4cLn2HmVMTzPFjyz7SY1hfP8Pj8dt9SjPR3DL6TPLloWOJ8mA9NqHwInsFkHgJdFXl7FAp41dQpr7mKEX3rMfrt7NcvPlZ98S/TY1z7dPX4anrom1m/MTCRMVka6BjUiu6jYRpB7pwJjGza/Ozr6YjiUMcUj7WPIFXzGEa2j0TPyy/FY4t8QWRZVZoqz8cTjAeL8Vz7KjfPoxlpEuP9qIswh5SvCEhFRufoEyrx3684+wAw9pnokDLAAf7GOndL0Dh6MOGDO3lNq/rKw7z//PGCJJcR7ngk4Y7806MgTc9EDyuTPEbCMo8rKeinI1DbH2EcfZTXdz5aoAPRCToYtWmOofsT0WN855P8d9JTmWb5Z3g1PslMn/8+1YpO0QztpJMgBdHjtA+beZqm6CQ2c4dQkDM88VmQCNhHab98GhJGPcyi3F6JkWRYe9DlF65C6WAO3QRzbvBDTdqhgZRj7Zz5/fULUUF0R5UeZ73Kw1ozcanSaeIPVDNipE/s5P+bS+6JifQ2cVdHlFuPCTkCCyc6zmD5GP92MJr4H/beBUyO6zoPrFdX90w/pueBefUAc7sAAiABSiBIgeADBAoagABBEnxI8ees8lkyGZnpGSUYCKKYFcSBJXmXkaUNLceOychmT4OSuIrshWQ6oG1RBCNZph9yuFo5kmwnph1aj0ixIG9sayXT3PP/596q6kGDpB3tfv7yBfiArrpVdR/nnnvuOeeeB3oCT+zAyH7mfKKDYuLyKp7kG6SlG+f7dsp5/GAnjLA6p0EYpu2GeB02xEPyCOZTVe2GdNKYkcwRdW2tVXMl1/+VJChV8hxjrIVqN9lx5raxkqqthELMfJbgHLvWfNX6vymyV+HGvMjhzoB6GyLqtFY0jpKAlUy7SgzwLjH6QmC3LGPyNpo6bhnpPNfYuJkC69bUXaqpe5h0fIGKGaoErOy/RZ4uHJPGK0s66wURJ3VSJOLKrCk3KfuPcZo5gkKGMX3cjt4m3kRIyGZWdiwrq2Rl97gyLZil3m7WTWGrqPZEuC50f5/Vd86bq7ClFrvgKmENFd3FCQGDVUquyMw+zAHMO8wGC2l2yQRPaWx5rK2jiHuDHaOesaCO3dztwgjMC+IaIK5D2mlBzTlOcBJkmDS9FnnnEIn4+Mvg74WcnEXceWWYBOlQU8Zo2cWSI+x8hrDznMKxvq+NcE1zdpfLsWg+46/mM/5qXjC1ukgwz8hSTqaJqYF+T/QfZyVBIa0VUXlWNmSLptN5A80CY5UPj2gqBOjAjVaN1x+tc1Z5IouGgneEOETyjWajiLw2Nou9OVa8uSe/cZhlYdyS7SRy+3mOWXPErKpg1lxfI7P66ZqtLO8jEjDMXkSKn33kdHtj1a4lsL4bLTphUHssv3aNAGavjkymttrP/9+GKdtgTH/pGweWHhtYClUtel4BKzUPVe28Hfi1/QO/1u77F/ShuWYXLxJF4shctjB1FBsJvt5gHmAv6NNe+UJ+9pkUP6lg2BRYvP342S8bnqDJa80CcGPBUHUvu9MWs9WG/z9obsCjG9Kt9lxr3ime+lkaqZE7+rhu8818R5dvRqWro9z5oDAHy15Uoc3aPFcW82ZkjgKuBdkxsNmr5gx7nPAoz9hjm6rVZ82l57KSii3ZbQv0bsdAmmfwY4SCTwNBpx2CNlWUm7bz1LTzFKhK2cx08uoGoaoArmX3JzOrUdCnIMdcyLu6aRhlBG4L+JwnQiZwHggG0huwXZ2CsmCUZQD6uIBuSno4Rl1l82WgOk6oGpydVS0ghccKANaf8R0QbRCdObBwtmi3LXkgK9lhS075LwXc1hrgjmgUWwfcEQIXG7GtD7t0ocqBAI6ZYmgqfdajoEYuaa6z1mTSgxli8yBsz+FSXu5gl5mzcyJAZ9Z3JYcK+XGUjdt87SyjtNkAUznDUyx52gAtbRZVNCPKfU5pt4TDaoD9bGkudNvyPPsagB0ct+wgl1ALfMoLoxfVuoBuNZWPG1GtC1FxvcgiA8U+9Z0oVpW0X7g1SZx8tOO17jc5/MJtJhEJ8XNZiJcdB9yvfHAbSpu2VH+TmyAy2vyPVdXADBYSB3fOoCttg4bbbNhIM6a/Uu4YF1W8YCOBzFzcrqfoykOMCDpKXP8m8JEubbgQOtKvDReBzSDI5EOQNd2G3DVDaj1tyTT1ZAPwU3ZoxU+7XTQ0pIQ9e54WpAE+zaNs3tgj1YaqBTlihN3foijGdw/YaykG9t2oSDupGFnHURJRdMxsERnsgEhlfD2Zbk+Yfe0F4CtlIXbikGncWs9WDvAXq2KyI0LclB3WiGzeM2anIOaCrIxDNo7BlEYUIM+TzD5kRri1P2RrCrSmlvJEyZGHugv/8gsHD/5540dEnH3bv9jb+eqrf9N0qT1vobXMQeOpfJs/YjauUht1Osk5gbtaRhor5G0/v7f7SOENsAf9D+VZD+msBfDjmDRy2VBzzbFnPbevrmp8io3mCFLEV7MoT3OE+RyBo8zkim72IMNq1kCed8qMHuVwrsxZXHIm6806EEr5dNqqUjdASxNh0QqnSVWN3CRWWcMVAq0nHm4wiYtZFa1V4GTSCRWCMzo2aauJMCJEzKbKRg3TVNloGpJQ/9ANi7Lxz7nxz2Xjt4Q5G3axter3CZSyntDKjKz5Z5lbfVw15RqpwK2JMRSOmavwc5XZyVd3ZutnAsUTwt7Iz4KgaVX4c6X4N6KWG+2Z52Zkag9ULeL3qUWsqmaC2o/der+7w3Xlg83JdogVnPeW0+gE5mHcrlF0oi4oMcYdwYr6pnHAsqNcFgxdRJghbg10ivP0ZiyuvkzseujuVgIQaXC7i79EOJ6hhnUO3o8yOX0szpxx29Ocfjvnvn2JKnFGM0Yie8E7yaiQLhfOhbqznEkcA+c3BbP8DhnAliw7ZE2DtcImWRpTGmTX2M8AoLWCyXzfuaZKxiOE5zw5mjmk86Bq0clbs92Em72T5teWV6FgxqrpMqiRiF0A03wfkIzdW+Z1nKNs4SCCQS2pUt1VSe8Bm3bPGmoM0laOAeXGGGufUUILfPb/uPq7cDWrhACBELaFp8rZIfvKTXQZntWQ4SAXvpBSebQZtGpambRp+PQGIL9VyyIa8PHzlpWrMhyu0LKTSPoap1s7NN+ifDFYhW0FQrMhkzmzyzfml30yp4HM6bijeQ2ZHXNtQxk04ABBD9QC3TkyuitYfLAORl1VFZtV8IyLgqfqx9fw5+SZ7eEoNO2a58XpQNcC0PvvHID+3xyAILF4cKpczbyFDYz9EHlpzIQMkQfywi3qkDqxV2ESJGwhFet11bZDGpe7CW2gIZNyCMSJavQrixLMTpVgrmIrEClHVIU+udZOZjYj6AD6mnJQSyugqBS+8LnrVt78c92/2KtieHbbdyIEsZFCXlMP+XSn0m19gkHRZZ8aN5UlR2svWg2sJsZNCPOiWI14YDGyMdftl8wYhEXml50yGx96JDnysPCSRRZSeoK2GLAN+DZpD87XIfwShE2InYhnNX8LdQSHoPTHZoDmXvoMnWTkyjSwR/DqbFwV7nk+S5ZF/XSXchUZspbTCw08X3dwcL9/6/N1G2XYwCVKmm4VdP5/+wP2/7tPz/pyEl2uT3cKwinlRiw4gASjxXODQaelawHy3wQOCHI43pspHKbX1/RrttAvRg0bhJqnL3qgnh2k28ryU/MBFVW1onl4qcm77jA9e/P0yx+rj5DtVxuyAVLVxsI60DR+arI8bRogG2omZCLHHbl4z7Us3nPV4XQWgmcuN7GpOSObuSz0XJx26y5UZLX6seGyf3J4xT8ZrwQnKyvhO5g2sh1q7sZaEploCV6RJ5IYnpsx7HtimE8jZ10yjDMm+U+agaXZsNVc1nMH0ob2uan0lJ6l5oe6wX564Q9L5TSFk6qaql4LkBA2nV5K4nS6swTxAiU4T4bOrVCvDHmCwUrqzHk6YsOAwFZcKrZ3Me2SRt+l9kXr7BEsCZzQFg28JOPdKkKFLxUNO14EbY64myEhbO4Jz5XXIZLjZI9DWDdSlVFlFmICuHXtBuMBMuNmD9EMyg6YUxhoZKaWLJymsWObyN7NQGhVOE1hYwCvHWvZQZbdDw1lpLvllBV31ptRE2lOqtgEcA+BgSsswmBqitg0hcB6Ta9LuS8yG4pvyAIY+NJ6uE60kE2ok8SKzLPcbgQgU0sa2jaJ5Bl4NqZPla5cWBP25Bkz1XwSozxA5o3QWF/MTLheB1mXeViv1R4W6YWV+7TvkDXQMfUj0vQM79dnMeAju6nG1AdyhtUfpoV5QDxhiistU5fhzAiYfNr3RtZWu2azbj7tfpN5EzNgr8mepe5XdoD/6ot0Mv/CYaFZ9lQrAqdTsvRbFn7sQgobM/h1A8DCgIJW7jTgb4Ei48zmfsuNOB1bnYYzAg9kAe5ctMcz9uGgTl/YB+oySWI3gERGOgHL2t4GXe2IipnZCqIVaYMFybosUemjJrt++q6Wok17A2qPDjIO+IZFGdSYVlnCqMc18YjvInlHuVsC24hfvgHYNZUsr5N/pwUv92lTId9UyDcV8gLylnI+QKMJ0qtbhYcsUCvVAVY/GMWB0MlgJTzpC61Exlh6jVDY9mmwnrNnhfQ0CDeqef0i0M7K2WQ4NywxHmywdUf5yt5e81mS5uHcygQvDK99YTX3v1ehupobdfZswPkaVndHyOxwoTr3tIcT/d7qQmnLX8z/ZD3aJ52AjGAj9STD8tCUu+0ygvBS2I67AjSSnwhZ1rLoPXQu8F2sJUAhqVOsgNklvGtwcgIEDm/RyMMdExyhpCdMW8OU5f8RU8dyLrWHQMNMSGDJRkCMRvQjy9e4HA2yp4JPYvm3/fy5nWAbfmqIUcTrDBtV0vjnutfQvwBzIe8KJjIVA4z1KxrapqxE08SnV+Wf0kKU2BsXq0AhwWxBzMxT/fN19UnupLCY1X+IcQfHDP8dLqv60GJSzpwyKumDHx2FS4z6UETQfUXp/NvM8LLsqSUBpExSneFp8I5sxbLZikixyARSiG/VSkaWkiYyyfodujnAov6EbJayI5PtkAagCAtTodIITFGlgZCmHU3Dt6S1jonfloyn97+lLejfXpc2ESADbhoMeDh+M8M2THTM2FsYJAfArML2BnEYmJ32QaZqnQTMJ5FAHGF7TgWHbPqS3PK3EBmwLr2vIyCgtfydAqXWQmv5O1UtGAlOKYtTkV1PCJTd26dNfReiC8ru4sFSTDbTXcFW8E27gjn5Gd0VTMtPaVcwIdIg55DwGkY26GkTIppUUJOrEQEVEkX3Q6QKiIynKyLPlW0s6oqmU64TMFUFzLgDTL3qomzRcnIGfEkOCXl2KqC3CtLMR8kss80nrcWz14SnQvmEYmwZRwgImnYq5GkCBi30vz1uZjVuhxlfPNteD/kQfLHqtGYQYnwYmTsqi+3xKnXV42e7GgJJuqGcL2VdvCWCqe3nGCRWqXuC/m0Me3RAzakFXmd+ptlpfphG4IA8J2NOs0lOI81kBJjuCirWBr3HXGd++rVV8sB++gQuBM6K2Gc0qRxMvj+mlwk681i7nbO/7U0C20uksc150RYZdCsNTgAKQPDWUhq8pb1VIWQ2U6S/1Ai1Wm/W99qXwSePavVKMiI8JEK7nfl6DB51owC+Yd1+km1mK1mXiSwbnfTrCbw4JoKXljIHjeAGjeor6XZpW32TvvkT0o9tev2x04H0wpY/Lj1q7KK7xjnUNS5inNa1XueC0GUKwXM932Ygy7PORsmrlPd7FdiYV8uP0JUdtGKagCPVGD58Rj5kz+T62Z7fXo8n2wCgWD64X1M4C7rLUjFEWiCeWipVTB0eeJjXywLvV3uGfHxUKNjeZU9tzGdZt4933aOocL3eZjirpA9okL+UGbBLsFOX3dMJKq+2o5XiggeNwbnAe6BWQLsJOuV6g2HkPdlOxrFv0ITUjrqTeXTckY47pgSEcc9z3GP9455In3kmH3cEQOQFl9txj+m4J9LfftY98grXMu7LB4w7psCXW3Bx3HApo8KJHudWO67jRrsXG/fl2gQUKjrBFnUGjNvTcUfZuDdw3OP94x5Ln/tOPm4PgMgL1ttxj+u4x9LnT43aRxOFa/famnFHxXFj1H425gd7a8aMNi825vXd9noMGG0UDhquMFjS5nJky91uthdCg3e7zGs+ooZ+oAMNp3XazhSL7cvNZWbb2eQKc0Wvm1yRMz561fv1faeVAzJXnJYGtvdSxPXcbBoHW2d7vfYVVa57Iu1nhVe5AoO/AvRlu56PmM1MFokRXnYandzSbW+pSi83ddub6JuJrDsgzg1ziTVLnIPetZNsPsjsVfLGJUKQNluCREGlmtFV7DMVhBrEKEkTcm1BsGo2ndbxq8A0Ar6JpuEVKwbVobkdM+uRkwbxKJliIVYt79c+S9anTqdbG6yyYnb2p9iowByLNk/9pW8cWHpsYCk0u0AV+q3Vodmt2/UxxvTtabyMhBHsMfpbIdkedvm0AHjhfXaaerHaYeySw4WcALJ1j0PZOwIhplLlE74QnjDTWovdN9eTs+sV2LcRclWJja44k77w4osvlo84nHIbsfzULe8+zciMyveOyz50Ir1v2fa0qgZPXEZBz8zqfnTabNFUOTOMiplBAzM+K0CJwEWNy+arauvp9NT/PtoBe3Lm83XcK1dYN5NLWDxDwqN8kg+kCrMO2v1EVnh1V/A4Sytm1IwuCSoIEzksnGB0oiOsoPzf4ae/bV8aVm2UYY4AffSMe6S3n7G31OWy5BxLhEGT6yc+X8dx7Kkhp0Kaqv759Y3qiv8O/2RNGN3xlehkRX7XoaTI+O5YTEL9ROV/kzAt2aakBHsH+iHHNqeBRmtlep/IxquVZ12mbYkZuZaBZQ9D6506T+Yq2DHkB2nHoaaZvk9QSOXl9/+XX+r+5WfP3OB+X7jphVuSxgstz8m8+9//+1/8se/+x49/6YarNWCaPAzsw7j/oZMea1hzNZqOyZ0LfFo28WIbSp2YvIntCiRV1/bdA6usaJUrWiVCesNLcChLF8MItiJ2uWAQfvMpFy27eY4Ms8YZCaw7LZ09203ZwB788wb0al76GC7G5OL8H9dxTK6O0hP45RmGPPi9Olh4HxqJKfkBpKfldxrsrI9hz8Ld//PyVmvBZd+gbmV9yDkVJBMuUC62IoDpVuBrSpZ/Gjqi4oGUlH0me5iXO9SYV9QwtzIpgWBC22wAjBJd4hsNzHNwMLMJlHQDV3yyGb4WG3SBbkXBpfCmgDDf3oafOdkf5pFMVzaqy/H8VUArACp5NbYNOJk4/+MrkOTPRYwlclYVOauqaRL6CT1CqBxX2WwCKc13LxDeOg/O+g3LWW584AWP0ShUUoGaBUuDWihhHsBaFiwtdoaYWbC02Npg1rJgaTtpB7jTDEFIJ3VJ6o4nYVz4CUQQGZInIbjFUrsWwi487rhgaUOq3UFNNFFai5Ius9VO5ZfVJZken2Wz7cYsTanHtFUux4VOqM0mdIXZsdq+ktBH2OfkKmLYa8xVxMRd8mATHE4uN/OLsptWFpcSJr69Rt6Pl9rXCuyQyHiDNLE9a8JGyMYsJ9tUPvHMdWD+zas65P4xNszvantHPhHX17hY5TOhnoKcm6GWwYdg9+tk7BlQXzWVe0hta53DMlk1IdFmy2GkvEUK4DoZfyKI2WOJMl6rY7nitb1mDxh6JGUVPE5xB+PfPXj1tQAyUglvNXvUJWUBr3WSA5lKU745aKjZvBF9OcPe1iFaoSvtQ/KzR5Uah6WypU77JpbQMOSIltzMEIjtW/Aj5Lt9awEMAtOj5hImQJ6nr8RRs59uEslt5jZA7lYpubZjbtHC2BwmPDGFmMHbzdE+//gdvWSnkXVkjvD2il6yo2sl0T1O21vTGzAvl8k0H13CyULd3HzYLEAiiY2hfrdubgIcD/FmBzVFO+X/O2wNB5yXQmwOcosGOs+jAqaHqSpDYg6hRC8b0BjdAcuSTnKnYyvOF5LpTVMnznedh6r76M6Cx2r+idXg1rCTI4PX/TmXcyNW3G3cZWUShaVJaqaW9Whtfy6oGs4nNZnGlJtKDewNTgL2aa3cWxDjeRvrqyly4maHrF6pkTc9VePH7Zpgpok1mjXX/h5TW8zhVU8r2WEAwVUq1BSrbZGtqw5vPduu1cDqi/bo2TW5ZocEf3hFjzS14rAg1puDDKNylaARzocFSJfyjO+wkjosILP3uLnheD8OmHYbYaaF0HHDryPKBq0FdPbqRfjWCsCVgrjojpJ1tKkT2ARHZtXCVVpDYH9vyysV09bA5rq/xwQk8lgTgo52CncV50CJLEHt9ggxC5q1ZPUKc323fX0W22HebIcC5ShW/1HS1erFCdrrzH4QCGj/XwuS8Br8HJLVJbUfLZKQ25SE3AmFtSz1YbIle3RHu97crod5cb6Od8omgBQh7H/PXHladoQFWawRFqvAaIs84jJEYFm5iyzVoMYKU7vfKYBrxhzlap6lyhfT17Cb41G3hOvmNrA6ApcpoiWmJVuKtWwyaYzJDTPWJyJ7XPjQrUmjU0omO1MEY2neqYqJuj3TdOsSpx3FVW8rhH9RbPbDYyioYjFhGbKCWJedWw++xrvH5U41uIyxbN3i893i24/FV6c+UVvfZhtPhvo/r2Fd2uc2q3leM/HWURzsvH1wh4nEYYH5LhJPmYLDnADcOBoay7hqrhd1u2SKMLhDYWCuRlnXkr9v+SLTNnQp9a8gxwxn0JLJ3o/FUkcTCip5NIFNi3OsZ4Y1x33IyJIdHJvsHzVhBKTwEYjw3V7fuqnotK5YUiuVby/wx7peXmeul82+6hiDCVU7z2k+Ylwl2+k8g8D0uWh9vaD5KhfWI8T/no2dvN2GmCE7m9xpdhPRj8ieIH25lYvT6QpknSlj276djG37MEyubJC524Vv2Y0AyodaIlUlSsRrusuW1XALqw0baI+zToJxpwDk8FJyCBDc02kfVYl+DSXV3KhmI/4dbiXIQJb6ZmMrmXfL8KhJBHgeyij5HSXdvZXGSZkRzXwKa5PycjKM6YwtAamBchhduS4M1wBLGyCVBrWmXupib5ijkJYsCjQy6nwhXRYC0CBldm+U+t8oLvM7ktcPtnS5w1GAiAfFQI7XD/avfz2m2oA0HC2QhgYJvOtBrdiDO+QTodbDlOzbMUU/m5MSc6Zg5Thr0GNoTL5sGzBDh5kVGBoIU7m1Hhhsw/BoVgznCxFpYmRZ69eboRdGX7hWlt+F/hWtgFnjKLH6TO5hhhcTSwzKmkyBzp1HZMEcska/jLlncWFeOn2NTQQsvCjRAXtLsucCVLilHxX6px34iBKaBlsQKlc2EIiYX75TKkx0bcBEr51GjPEWna1h8Nqx2d2xC6rhZmJQfSBKezhlMkocZg2rnCbgsuI+KrR1xTJxFngqdLnpG7YHPoxcCQDXCeBIwFt3Mw+5MGZIN4JB2YFkuB8PLI3fSd3QGhRRyoqNKnCinHP2tREMt2vhdbi7jnIWj5ogOrflw8tRfrkxtzLxPPQIl5hN/OVZl2nPQ/OE1MsqvT8jdCt2BKyGCyh+LN0bUjHekA4Z4yxYNkEMMXvs3RYihVGCaZhSxbLrRlk9oxFPjTVeiQSCewCCGBq5TWAqyhaDarRQj7PtdS6TT9eYqZT7XqoMfinGWa8I2gJwAWatTy7ehA1yCbt3xhC8VIN0xBSyflRk/u3s5Lx8bt3t6X+8EfLdvLJdm7gk7nRkWgclS16/kEFXiV9JWdnu9k4EN6RpFKB3yHJKwwo95h0aIhWNZDTbCaSd2t2Yfh5EqG12v2QJRfkilzvUh1CH0NbOnB3Sk4PYfVu1e8uwmT+axDTm3CnPy3h+2maX2Vn0CvZlfe18hGcYEVaYIH37TtW0xuao8FDUdN8pg6v7uTHXzlqku/U8uEnCocb9yIcOcIvZKP1lqcWmecKjgClQFW8nD4UBbOHJFoeQUFuBx0MWMpGDjD6ywLmtiBmaz7dOuNRyuGxxcOGXVfZL3tlvYUEgFVM87KyFOBXYAxEf/LygjPUpM2RTsAoYgraa3keHpDIl8HLC5NJlFfIcUpSwjvUoCFbDmApmgmY3N+HxEhgaJVVSS8lRLTtOZlKISUEOqn/FIqT+Amu2CYKjagyG7Q2N7iLLKaKhYRUtLbblwI1ceT9wa0Y3M4VxzoXbTpf7Om0NLe8rBDWQTmt8SEudaqZl/DylGugNtY1IcniIIbJiM4nNJ8v3Q9jFfZZCTPK8o2AmtKNoJiRP3Ld3KddHswD/hKDHWSo3dpidd7dkaWTMqNlZ4FDtNp5bhWgXNyXbVbNpbtZaJ9r7c8VVNWMxa8kmDWc5DsPgHRS37qSarr1HiDczVMiuDHv39lFqv4XdkPnaA8u/7Di55OydgSFM+KiVDXWkf0h7UulQCwzjOtn0bf61ZEgVSYiqBJtHmC8cXj5QrAjEfhPZ3Qpjn/Q9h5+4jdAy3y6bGgiu4FjE05MhPWNKBmQQkx273hLRYoBdW8Na4t0x2KjtDmGG1KgtgVBiGir0S20F2cTme7c2QWUgIRLGy5KBlGIOyRTOY2WUdElkoj0kIyfDJzmRAzPXemQNOu0soNPOPnQSOVqEiZ58c6EYkyGJFAjaWxge1ZMDdCxPehLxN1Kbj7qp2mPF/WqwYexh0BC1/TBlzaI9/g16Kt1MQCdxUIAVA/3+xC98a28vEZQ3O+5qZfSyBhIORuJO2b7xuwcbPFjK7c7Baj8NPSE+GbOYRERIQYm64tEW7XKs3cR5FVW61J021b54CwYBdXxSJ5LlHwsRosKCGNj30IxhocRCuyJm+YNOxKZMo63LMJUL93SstFFzI3S/QJ4hK+gOxMbaK8VGVSH8hT8AEe0+TBlruM6NskLlAiAlz5sONvLSKMdDWanWP5n1VzSZ9uBg8FQ6UWMg4aLIsf+A3XL+xyS+okn0/45NIqJiZMmLsVEqudiih4dVXurpoWxnc5kVexYFWJoZuSuJWz165YD/25aWD0tz21INTFYHNxer7UermDB1xOxcNSPZoWfvLpFw14NErDcB5JGd7RF1zc/Na/u66Odd9PMuhlkCVbOzejYI1dYS+YzTYc2m3A7VBFWDjyPNuRDNACfumTxGR+NUsyCqmWlQYCmGmP4Upq3uhP9LLzQYrjxdoWNX66zmmB+24Prlvb0sD3W3Z4a7ybAeeOQv3FXXZO1DaWiTRw+bcOEOZlI/v1f9CPC0ZMcAsVReQATl4S9+y74Q9OWHlr6LZArnggqHhw4i2jMFwFjZbR+ALtsD4yDdoLXPVj8e+P6KPZVvZtaodNiqdZgaWrbC5gfZ0aDu8sP73OdLXL14F7xK4Ew7KUgFMO1Mv/aT8r2z68TrKLFGndBRMJRrAKeC1Ev/8L20g22+mz1zdXusnVl1P+J6obKa756Vmo9aE1pIFEyOWXW9ivMc1aU8SXbsvGNohhfTDLXE3vqZaww+b55WxCvLCre4FlQrXtp9149KMS7ebS8ee/e75OIzpchHeNyToYPpGT8zdRCM3d2RcX7HK4Yf8dIRGJqEqSeU6AnUi6uILSTRCzUNtv38U+4XuosLuab8xb3u94WbXrjDvflfn3K/IIjysk2q/JT7Ra3f9Klnt5/M7XO/oHtUucHlSz94Ya/7lcq+7c6qYHcdNTGUbeEzOpJt4RkOJF5w/S/kxssK997dWnAd7Emx61X3oaRsXIqOuX29nim7KOPScrza7YqcYKTBqzo0VUfwap2bFFMjM9L8aeJMBQb8xt8V7DYMe7+Udn9MnsI5NtwaXAU817nRj/4NERQmV3hKJCEleSK2qOTnqOSnn2RpMnRATVceBx8tv2fixLpbDWU4VSGxgYuSdgOmhz/3bunIC/9AtqgfEvDZ3iOnQv+Dc9mDZ/sfnMkenOcDWNJdEz6LUroepU21VK7o4IR2eelP/zPio11qeOmM7xC8Un0gDH1a7FgcPu8tJhX3FHDa0Uk9NXR9zrMROlk+PSgI6JC1AtvNiPnurgkewd3syCox+RvTHVNiePJKViTfR1qUTnRMWeOhm9i+JdN7PQwbZZaR3tAqxjGtzfeh75zEytbgkEAd7njpw37bszJRGkF/vjtF7tr4YIvlUomP96/XeRTxs4XbffktMtmn4cHWEsp3p8Fb0riDOf2r8k11PIo6baiIkNwM6EZXbJBU9oqkwyLcP0f/Wm0mSz7vuZnwq5+YrFfoOOAzK3hsXfPKcDvJnAj+2MtSO/BwX3cA2q7jwO8t6nAiotdQlurXGq9Xabweq/G6yN4xjddpcRSpwREz4Vb7jNeHrPF6ZCIYKlcMGywvnk1q14SnJsgGUTtbOQ6BLz01QQO62EbXkIYWz/LYr+zC3IyYOkjgkDVbL1d5GlB2Zut1jSVpuRq81W66Ho4wA0XZNNVsXaXmUdiFjyH8XBow8AVMc4aID2OFnC4FA1M66Y3BkCde88D4Nkkm2a5k3Iz3iL2Fm0rhJrtq0AKnQZQW4MdrQjsqsbB+6BWbRtl9yc8q6rSS8W52LDIl98pcRCdgug8e5MRiex0kwXuVT5GRTmr8simB/fkq025Py+VzYUdjCjceoTMhnAdPzcLRQH5vgO9gHbFaN8A9SFjtg/SJNrSP0vih1h9mlqoZ+JCNqWLcZWZontNBNDJ6/ahpZM/uaiUNfNiw1rYl7Z12rPkJy3QMK7MWbQufC9tt/J6vthOXt7MJRNuor2yE+nOT/PjL6icQ7qMLQHuLjks6fSqGbqO9VQcI7dOlmt47t7UdMW0BdkIPio3OhtY/Qf5QLalnBMnsO5ZnpFaxCconm1MJPuL19MVw2SWhvsxc1k0u68nUqel1WdhfmYXCG9vMtm6yjSiCmabpMPBI35cH4/JgPPdbooxRl/5sKnhfkq+DmetWswXPL8UPMOsSJkkCVNUQTtWVTelFZcn1Ap0v9pUop/Ohr1+GTsB/ZMg0bJQWVWqq4bIz8Gq/MNHebhL5/3J75LzBmuFMyZpsKUfN2ajwiIJxktxsJFVzeR7GTC8xWPsavNazUpOX7shLd7hSZ2JsSUQZJsblYlD49araHMJLc2aILkqkRq5TFVtpP9CrWH4aMwbK6Al5so7Ht3PSf9O+hrG85SopmBIXlqxVgyAWvMg7p2Issjn+zomAhN+WI9jCHLO7ugb6cokkSpv8E8l0ylAWN7Xal0qBkADDMEDtjfJDd+AxSKCTGS2gNQjjT9AOM1LrO2RHeEz9boqtyLRtkeUBA84ZCkIzzkMGEhCQR4iqjPYsqcdm+XcJjzNJ4M0lTsNM8/kZcwnM59tt0uDokFUczBSHRZKLaGDS1CW2qbMQs3vdjIQMMtNvnG43BPPkvXYfobbkvj9DG7D6VKgOeiByQ5boISVMbMaoZJcpk7Wj5HfIbNaFocbh0OnHdsn25D+E496iR3PjcrnZWvRoIC7MJ3fHWE2TiYrb1NS8j6gz+Ae1jnWulgr3JZ7ONrCgbHSqSWcRU80GMU9/ZXVOpFYjuVzw9rwPdaog73YXTt4iclImIhdfLA940SjaGsX4qMOIiTjotStog1IUOFdUVSWMhGmC98WKh9ZWXMX6N2OmRU3IGDZ2OABVtAadiZBUWY3yh+wG2FWK2NB49Dioob6WkCusx7bB2stRJzvtaKwmsomO99qXabQIBIKDgJyuyHYRkIKHGq6S42hn/aC9RQM78JA7dmVAaewFyjwwGFWTDgfWWUGW1ta+SavoPG6yz+9Xzwo3g4IWdrTbFWCQqyrFE25O2wgec+L0jZH+NwbMV25uaEo8F5SubFVFAbwJmkt2q4bVVjaRnUE9gOpbM5Ix7GmFmioS60YfpOjk0C3QvbI9iNZDM5xO8DzYKEH2kamshPxU5lJ94zKTdNuJbCjy9Wa6wSSXmDnNfEWvyQRhP8wWPN/CmGzKqgixmXEuPjV6S0RggR3PnFTfVw5HyC/LrIe5FTwCIvL8tWRwVOhz7TNp4JKFTcluEcMKQ+Q6RIZHTGBoz2tFZhIU0S8QoYfeRvS4RXfGbEw5jUkHfmFCY/wfZBliRtIjr9YOBREm6Zk2yWAJel47aU8lw+y8dowirbxuHWrXFf3qmP8LK4tedUnIb0dM6L5157UNUzqKrFJIIA9n6eJ57Vj/ee2wGdPz2pqhGWsojDydl0JTdue1dZ7Xpt6IblelOh0QZfTUvWDkIzxISiZYKiOe5CmUPaUNUUBr8zFBj7CTrFObN7mq6WnhGLAKj9dZeNSyg0Q+siCpgkLKdmcDq6hVO6AxmUPDd9Dgl1U94FLXPrKxAA16xbRHURFVebpmArq0+4iA4rBItt0RyvD3IR0fg8r7pikyxwpi0gKTJhwujEK96eRQHtOOtkNACf3EdARLMhuOcPmyf2XHtBwo3Lip1VMMEskRvD7UHDLAScAAhZN6TNuwNzymrclac0BumMlOjmQ5dGuuvB+6k2YEmGaBvA6EZZ3GQ2Cnm32dPq2nyfdpLr+QylKhBaPuqDas/mwYl2Q1lpiTMD7pwn1E/UzOSFWtTku6a9LSnulAVHbNN3SEBBgmCa9oyC0Zqq8u6AGcOZdwfInF2bCK27NI/SR0B9HOhhlTagwpADFF41S5IzYXftbJ0vC2hbuTydPJlJnq2SiBZ43cT5rJXhdP9+VxFjRhmIhW8rItPXyu12t+WT3WERmGOSgmL3iI0Pu9XjLVE7bAEdFRKaxndLVnRjOjIOE0Jsw6mZ110inpWbXfMmhKnpmhLk4ZmN3KeXePagSdyIyRpJZpTiPru0SfOA0hZIaqP1auNFYCRiYI+OvbKaokQeEcOsyuH/88Aqeo8wEjPcBfKKbbC7OPYcdQrS29J4boIm31rzJrQ86bYkkjBpFj2k5mlEZGauLiS/tM9Tqse+awECL4ctcZOledm7CGk+YHk9GH3JykVI2PfpSUKMV2cJ8QQZnWmhlD1LZaUQqT4rGiUDa+SmJNE+YhM0FqgVQSo6tmAsJQMmEmCPAh5VTcrfXjs3yKBb4mnT0gBJPZAzGsdYp5SgzItssKpgVYMrVmBFMfbQ/lIxiqZt/Qw3+dGbvJLb9kYs2nEx9lIjj76UiBP56gUejIrQwW73N9aAxRgtFMrTJI+ToIK5569c4I3BpLxby2CLHUsBanTbvdn03G7y74pArKNc04Yinln42aGYYhNuP/ULYY+UHg4Obq6fZoXzRRLIHxNzO4z9SqmZbHVZqYSFdHzWiXkS/65deezIEs3xEzdGMW8/D70+PvZ8dgqSekljglJDR0aR/oKxVo1tanGjG9JBF86x3+yf4Mi7QYCa2b5M1Jqe45U5E4W5ZRUs6u4dZTcYR2KCvGgh1Wrq6qObBhA4ws2ItU16lvJb2wGpRi0/CwEM/I5kyNl5Aw1eXtxJ5Hvy0zTmcN6z5YZgD3JWL7pNBbxMTndjjNKRhR+5AhVa4OWVFzDMzCrDVqn8JNS296ZtZawbfSpiuo2ALLhs7yTjNvUOU27VjjuvCJJ4WL1Kg0ZmaRS8nUDth8CTi4bc/a9l3TtiLWwhU9i6U8q4ZgoOdqFDutpLcK18hJzOSkTUw7RtOMMRepTVU1DZpFNFyk+9BhaxlAnaMnHWCX7lgSAbus8ezLMiM7ltLK8SWh6dBZlZfk7WSDzQVDy5VRK+kzdbwBei8z3WxbHWLXmQ3CYEdqdoymGkyj0l5KGHI3kRU+76Iiw2NB53NMnW+GOKNUFHLq1qn2HOGXQU01VjDsQ5o0Ga4wBw/LEBsP7h36KYRySESzTIG0kYpHgyjEmhDXbKRQQ72Pu+Ts2RBYUxjnlBVEaQsJSUOYmo4L/as1q+gyIl+UzYh1vm2lK2/tkPmU60VB+GRKK2ghfwTgqF2YtfGS7YzbUMFTmHi2DIZSTadbi9Lzl/y+cNMs3kwXbzjAKSCn1j9jyhojZgJ8jKXzijqJmYOj6zzCr82bNrrWhgsYLFMtJeFmbVOblbi+ZnJTMvpAhiZa1JikvrJZNbXSaJeLaVlD9ZuoHJSVqzjhqaRFb4Z8ESMCY9SepfuEvDCtsbidL1IZvkjJJuFwzKYeEuQKW9am6+cksEDXXWhmF7OlJ6v9CfsxxYap9BmbQzyrppVVP+VMmYptdBmItanL9X63XMfgqjxmRUkz7xYdo61OarTVESWdiLVE+w1ZgOPgOpZw1eAKBElk+Jo2AhTKKkr94+BdZL1ZUguecl0BkNhyBDLrLP9j+R1rAAK+cMh5iarsKH2EdTziqxv6nOHbItg3mTZ4aiERkRVa1xHqZZVXM9gAehl4mFuxpScsKni1MBFmgkgr5E2WK9X5qnYWHtKMqRggVzP6yJbXrUA5TXLcRgzEGjWoiMYj09eXVmRa9sRhRN0WUHVUsnb+cL6N5N4qeomigaZroMqzQBnsBKKCT0hlMr/TFo3sjqk5chFvSjjieZvivvqdKPazCFulLCetyU/G/PyYAuJqUiocU5SKxxQlLFKZ26sgiFilI0KdPSgLOtKTijWVVV6ysspFKsNOoaZ8WmkhQFx+WQI3vC1sJrkMdFeReSmZSnZzN4MelCDlSrNNq5FH44KGnuUCdrSHCw1pT9pY0FVKVSWVL2Dwkvombp1Nar2krsEsSpCAvKTRW839pEpInuxhEOQjRUwp9ShpdjXrTt1UCumyQpyF2Jd78iHr1g8qXUAKH4zwA9PFyX5ewbTcT0sFsouuwmwr/7IpT5qFL3fL/W7eN3i/T+73FWraIfc7ZDC1HipgULshdcqz3LuHn4yz5zlLzElQJb3ArGucuqlcHRawNj9NM5H/5Wq/WrCl8Z0tTQpKsfpTOIFOveZnFTU/9EunvEURsr7sqZY31Pe+8+hPwe4DRftXrg7e86Gfwrnx/lOn3iOfnfOuDv7qUZaItCWS7rHl9Esf/d2Plt6aRLv009TD0fz7PpRd/gFKwQAFu4Ln7RtsfFfwXP/tmVWtWar6jF6mK7uCc7gEbqR/gKuOXDzLCzQJGS1Mn9H7Eu7D9Av6mr173n30pcJLJRPp02+6p8/1VWm//Zo+te8aJCc/pRoZ9ji9z0IxHVl2owBQRpZbSYhoVogtmB6CHidchAh7HKfeHqD8AOCzK/ikHXG4K/hYPnhOlVYn4nK6e1cQVYN9g/8KsnzTP1K3k9zFl8KVI9TGOGZHfquHWzLL4b1JdK/0IaRto/Rl2UTHU/+tGk3XsyDFaQsjCYYauJRiuNRhAezBaAEH4feb0tuXd2lzug/L5GL1yJhqMD8sqTIlPI4YQhFiB+ppPWEQ1eSdAP19jP0t38IwrKGz7xRG4EQayH8JAjiEi8eX7cUy09NL72v3pk0plDGlpXvTyjIgfBztYIjBvWm0nETHUQ/uhUcN1tz72X1nAAAw6vBio07ivnGHGHfoxk3Q0YYvG7nGGoWad1FxL0KiLbpA4BUXNL2MGYJKybbaJnwexzWiejKEjG8qJ5LKsvbGVI7bjpiAtgeweKsw7hBwqIaIkuhbhKmB+RriONEWZJdWK5fSH86AzAdae5SzMXSAmU+ET/z/BN4wZHz2tIM12J/0vmUBDpQ62G2ovSmBeYTGuJRO8D3BjaDKoJP6NnPMy7/DSamFEJ1QpLeEZoaWRNLfddjJoLIDkgXZqiRGOdbwyKyAys6fAEeAoJY4E4ITbFM3rCYaBzrAER+bVElIdJhU+t6rqJt+xfYbXB4MlGrD1XSljRX01MoRGoGOg4gcW9bpVYCXVSit8qjgFM/c5pFZPXUxoMK0ci+n4dRf7+2kTU4AQzdH6ann5lmCCTgB67n01KkRlsgUlE6kI/cC6sdN6TgJ0Akamq3rYEaOp3MwtQFhXlQUs/48fRNUynTmFRWaoYn20hmwdfcuyv/zB1sn2p5GpdKZc1MkbAYksxgBWnE2zpr0utQO4Y4UZvMbGypd0/UYCvSubPtgC27/LeiZYRRB8YKTJBN2XI8uhU5UMzphyss6WRcjFyWLvh7QV9rL0bcE9Czl6Nt372f3/egL3XgIY89wXxE3ZeCHYf6FsiYgKF3gMMEbIR6OpzhbwQWBoQNTT68oI4xSF0Vb4HJVTcdq0vVKHy5XHC730aLakB4G9uFohsuVAi7HgstrcF5x2ctwOVZcrlR1k1GiLXhwWPtRJFIh12baPFxfS+gK5KZAhLB92606o5qgZdjVHQkNOYnZ5qFchSVhuGSdjvjKitNecj+V5oNbtJdPuF5jK/K0m4WOrd1+MRLbgzCvuMAiHdBqT32Ig+faeDl+qVbgl16SW5JFHLWjqjJlBMyvw9gH1nTSw8WkuiwkLTiCHqQ7dgUP4vNs4F8iA6ebKe6fVYbOMK5KdIvqwW9R/UjYX0HqXe5pB6LluiUJOeygmk7JsrVDrvVQgxJFR7ROmaEObkIS6gpxp+r4TcGxlYP1EsKTaZ1/pd3EEpX5WFbFiLeI1dHR1UsPwRgTCN/0v1ZqWFo7yOIQYztE0JLwSB2f29ZlVdxY92u07JNGBIBZjVH2Em1xPR3IQZB8Wd8YJnqOk7dnhBeMb6EeCpHVsulPog7nRWiwVsrI0m2vpslbLMPNSiL1JtGH2MYX9elsLaqiFI3dWC8JcSTFxTvyagkygZQHVeUe7Rwdd8y1LGg7GGERtMJ2xumTeq5AvAj1Rxo5SnNkD6QqSHd3FBsySAKOQkt4zfEjzQNuuJRAZniX8aQXQxHjORQJaajZQS4hhxrwy3Ifn1l1s2k7Z/kUlls8NXEmPpiC6OAEBO0+11QuPcjlNx/9uyc9yHzcZ6zUYPokBsHzfnEheqXigslEBQThDS/3ammFfrm6PD1d+bJDQRXHhiPXcAkBaB3FZIwlU8qoI7epuHOxnhQop+d6EsHccLcScjJU2QxXeNadzawssAp46BintxZr+qUb3Vc9xkvPMYeh3XSE2HxfjibpraVKQsg1fBztx3Vf0fENnBUAw+0DJXless9L2fOYWYET4aFKpNWxSguBE+MKoC1xWek1+DCVhUJLt3U/zD9/PP/8scLnj/V/jqsOEMJjRXAliSjmpf6NZDzuW7ZB6cL0RQiKeKOScH/tEzgS7+Csfl8TahmxG5lIKaJPJRf4AsLv4CxYSxUxQrAccGsBq6K2SrEyK4z0VdFGL+RS1I0X3AfnLarbaCvujtRP2SuY0Cmjkr3qqYkAGZVI0yZjVqs0bnadmIOnoOPZ+C1h7DDAgyVJxovLOCOM81E3zqG0mU7A5LspI2l17DeaqcUM7QqmtZFmRrx2yZuseprQmLAP4C4QKsbpszJTTshuVLbbHCYuvX9Zp7RkCVBQEBNLdv5KlOULkmLoyKhK/yXE4hfpQOVEwf1MTgzJp+gyiKpOMgyd7B7mUiP2n3kyH6VMCim9UikEwy1IIV4uhXhOCin1SyGyNtn8nAn2C8cED55sysBY5rKSBycbFYK1/6QnlIUftQsjQqT9wA0KQ4SoUaLQElJoCVVoCek40MbuQKGf7HuJe5TIIdyLfb4FRwoKJUmFMitRjY33NVezrQJvLkbhq0rhKwUKj+4rvaS64OoCjTmsNCZNafzOfBKHW7JoN76CjaHqyDGY/dS7NPgaqOTV9F2Ru+f0Dp5AsJ/bpY8vus26nVRe3tTh3h6mZd0LQ/gVCLdFoETgmyoQNRwys+OL0JqQ+8nQOXbkKKVcdlF0xoyXRLRVdJYGC+hcytAZvnyq9uijSboZV4S5sugcZ+gcD0ZnitA5Opcuis6lAjrHF6BzpHgcya1d9wWMLl0Mo5WxWIPRER2RrMOLDg0DBcMYD0LqUo7UThiPD1ImLiJ1aTBSKwfT32LNNoxlZHVjVqWkawzIMa0roabruFJVVXYIzrWkn/BpyY5AGlAHLs5PTWerUs3ltnCN3EZZsqTiZcYZFdG9lHMfmfJNuxBeIOgEjEnl9ghi65ygYP8usXaPwIk39X/lwvZQ5fZQxfZQuWB7qOr2ULnY9lDJdVsDdghVwKpvZkVlaScSV9aKxDXGgqS0bUtwa9/2kOIG88r6dNFF3789xNNFh+wbOsCa8RRdfLfoomzRRa900QVQheWLLsgXXeAWXXTBovN0D/Eu3ENK9CfmQgt0oXm60MpSn1toRKJp47mxWA4FCpmLrLKAHGqQrbNIpSxZZ0G+zgK3zmJMdkCFikWUQoM12y5tWK0CWleM9kYXmafLxbOLrKIY7jvbBOuv7F0cnyv0miQ+DzktfobNw8TmYWCzB2zWlw9opNFhxWYvw+aKw+YKsdkrYnOlgM2Vtdjs9WOzNwibPV3vUbZFZkx4AZtfVnGuWK1qcxMrMsvFxRXnYU7CTOjYI6c4L+WK8yjTOvGsLqwyILnzstYjuV/jkdz5ul9eAdx0kd/XSeCXeZKgCgRnEl18MO9dViPxZQ1gwDDfQu38XHyKDsuTwMgXXlFksBl0A7u2feXvgzX7ahKTv/fpKT+Avy8c6JAdk9f7jxCAIT74+7JLElODW79qNdhocAS5fS3jFWf8vQ+mPXBMOwCV3dlYPVhEwgxHSdz3KoNcBMpfk78vWf6+7MK5+Gv5e3xrKPmwB1LHS/D3If3qBeXLQHkfKK/f8LBBWHNFeR/tB/TTx+CaWvU0oTGBBz5FGMcQ4pklkREO3pbTUNdeoByRMlYqxgku2E0DWEFcRwZH41ODpBUwEKANpw/iVdC30BYBqsUBwiYkOidsZpUbP0ObG+thQX1aUKqO9MmjeQsXyKPawmNrW3BDGoHkLERR0bWAoOFLImj4ChA0GIygCnSHoKEiaNinLQ9fAk/DPuQLvz946rm+DMDT8BXiadCHp2ERT/0CnoYXw9PQ4ql3AZ5WB2FgH5L4BXQlalosHvShant0kj3MblAgy14/hyGU3QS6GzMbWpARZRtEA2d0bU60r1uej/nydVf0OXsjYDACbdQyGB4YDDIPOYMRDBJSReAuMhgxGYwAQmp8HFYRwmCAGhcYDJA/5Sx8cPUKxX45tcjXxzrAUCVVX9kNQceM3UAmC+W3fTc232KxR44jIMcRKMcRqLAak+OIM3HVA8cRgOOAJtfnezIyy3FQUwIvOo09cUGbNds0uRysDE9LI9uhjE33lX0n9CtWVaxq1xXZ0NIV47esHrZavZXWwXVvr5c2T4xYnHiRcPCYg5slzXv38Uzgxr5DjHRlBKPHd81f15AVCKJbfXDYj1eU4lsLhsBG5rnc8671MBErHT0mZBZFDU2nWykO6PRN/1oPwLpf3wz0zWDQm8G1HpDonfpmqG+Gg94Mr/WwJk7qm5rDET8UTQMUokTkU3u8GsEM1HdkgQdlvDgGODYVWUqXBhTUeVW5Oqi4TJI2GLxvGQ5hBzRnqXvf5SLN7m0m2Owecp38l90brZU5X0OkVArJokFB2rZ7d4Xgzhuhh0zJ5pvUVyL3iqAbdQIEgIkIDn0lcK+82vOuQ7gYBX8JPzAYo0uXCmZhag7ncX5kXhshIgxXbQNJjPlm2tR7MUsRJXnMbKjzFWG+4LXjMyK+ZqrBjzDi1p24cgJhrO49rsIurXQqegyNR5X8UQWPagO/QnAie07d/xVT0/g6pTLBR9T7xdc8pcgvBeQI8uEAHKEiJaHy0l1vnuDIB3W9iU40B3a9/6u+rhe/6u/66AVdDyxeF2ci1JUX0W3tJbs+fYJTNajr0+hEZWDX+7/q63rxq/6uj13QdfjRKnY1HSpa0oHBeP4uQSAguVe62ispotav8+r63si13kj/GtSq8rXheVd7XpaOlktEX8nXhuft8jy7KOwS0VdeZm2ENo523mUhkdXvBUG44t8PtspSQpJBMGWYEXurduN8GOiPLhN9DKxzL5azFyGen8zKh1gOJoAG7FD1Caxf9JfTH33XeypLia9CXoBjpZN8HvBrnS5+Hepuwh+wfffZx0F6IntxJntxWn8m9KepPyKUycS6z5ayq3uyq7tdVYR5On08KWEbBykx/s/vR/yj5v04eYXe3ae/QYyIP9wR7VUzu6pkVwZYFYA0ykaspNGrfj4K/fv9lZCuak8m/n7zwEfAgiBaPfQW514MbcJh3JwCPD6CpCHewvTlC6/7Xvv/2evCOB/b3S04SUF2Xz1t/Vpp//PXUKyymn0dOFX9WXiYO4/87UFodn8Xhv7yhfof7Qmk4gc+4b/tuW8d3tvtLVz3z+/5pa3vevQpuXz9wgON1z/9Gyh95z/5Rjj277/AUv75NYSKcxW96wOv+vivPfGLUtEP+u9vLcVfwXvPvPcHP/gnl3n75PLI5e+d23JteK7by4xwu6d7xsvHcX6v8R4qJIROPJP9/W/vp6vob9VPGJk9Yo0bg/QXv/JJTlQ2K1AeCyS66HF3ofyGiSs3f/gnPtld5SGUfevr8taT+yHpH3v3U9BcdVcBt6586b64nm7dpR4elLqnWdvq6mpWQbeNJfwwltt+784W76of8P3wZAGCmOCgAMRwNYnyx5HUvYrzBvxdeHDdb810/e/e0Ft4++1PTy49/fcAi5sJsw8BZvIOsYVXC1/Y/cCnvv7dx57sLXzm448/+XN/2r5B3v75Oz546uj9H/hUt0cY+73Vbrf6a+1oeCU4ObYSOYP2M9FiUsoSRsfkkdLptyRlKki9m3A6cc+SEco1RGZH2OMzD52ytmTD3CySKtYSzcErpor8NcPQAJXpIOLoGZ2Q4CIYLqKOZ1gH3aLPBVTxII5Cbkc+kl82meYlhnMS2yirsuVsuwlZoqkRnUbTFT7jAwqqsuJHaDGuslwZJLxsGsWANzWmmamaupPqaqnXFyilqZkHpL/n3JjZLDutWQDYARwr3tOhJ1tghlNYegvk2nUQ5OX2KCl+e5xe1vptR4gf/U8DBBznpuFf0HLaZ7fftCpu04D5oU3xpq5rQZY+gOPmXbPbbTdJZBkNkcFFR+HFJRNT8PX3NOuaZlzCoGqm2jHlxSwpQbPLAWtCRw7WNADKBn2GpO6aYaz3vqEiZNfKW9vr0lebocX2ZLoDP1NIsInxPxfK+E8ihhSbhK/3jBajdNZeHoPLVAk/cwLdH0Gkm2EAizkPGDY9oC8L0SP1DyXjzECF0DSpS9tW0zPzmgqgTCFRN3PGIlxZW9IsinDndCT8hl4yssYNduSjDC9j3WAbStAbZxOHp8eeBqiS5prPmms+QxgyqjpJrnT2RuSz/z9aBoPGBNKBtiroYUPKWCypF9BDprW8CAl5gy5epIB+JUAq522WqwpfGkhpUM9X0uv+GqgL0VAbMIe5r+P6XrUeuGPNP6Kpl+vXub29D9pLc+5ibcznbczDJXv+7CrwKDOZHQM+GeJTEWOhh6ASV+jO1NvkZ+qEPQeNzeTb2m0pnu+wcjPGjEzFj+GdNfU2ZBZrw7MOGJkG8k0z2xLeTLVU24UpHS+GPgdeJzZ0SKyYrRnX7ld8r1tctoRUY9KWqUUp5FKREVdk5ZbrCNXHcEkBwuItUpcBJAFvn4wXvtWJQwgS/Tjmx7ZX45ieRQ38FyvNFTTa0JcBIjlASwPgQZ3+aw2es2jt5WK/yibIq0aWlSCrGhk+6tQJhVAPye36RuB7QRVFPtB0zUSVuROYYJlaO6RFoK8jjLXyLbcpk84piIkW+QOLU6vEsuyB5/2wTTk2fDPTXg0vUhusOUWEyDT4cF1HefSASZBNi12zE4OX7OQYK0Y5mckJSCY+Ln/yRdkATWz05zjmMcmsJpynd2CgH/Krk7rb2YBQVR2cTgB7oi+M0WkPeeIYKP4eeN8RZ7Iq8F0tQupgEHn2u6Fu/he+B4fTUFOcdJicx+0lwgaM23zAdDCtdPo3U5d+/G+w/dW/T9vfxMDtb/xl9j6XRsk0GLmy0YZ6z9KidFq2uTXk6Fj65gOWjrwyAhrkpCm4gIAGZ/925JNbdc0RlgFf9bcqyFEtogxVo1Xlj/rShQ/paJV2kkgdyLfbDG7FqjDpPQ0svoKpKUBDVxud6QMXMgffQROYxIrrCB3tMh/L4PpgSbw8m6VzQ1wZXWJaBjGVuHAMuDBSbDfP2lC1Q3SdF4amxhUm8mpSXywGgoA3ZJA6BW6QPvh/AKm3MfJKkOMP8u/eSpUuiaPs/4fbZecCWLbxtbq+zTKvSDaKro4yDR22ZbpcV9c4jJmoEflB4MWFsBIbyQjVIwXuqK2YA0mwSGyck5qeTI5I59xU8cVRm5WK8ek2kS9Rl8sRs0mIpUaVaVOlN5rNUmz3ZtRApo30iGsyuYSjTuDAnWwGvkqVmxxPLvOz2Yys2iRLI+YSs0lv7KLdRP5Es4MdsVMT6ODYbKHPwIt8qGQK805sYsPXWOIgrW5yrVqMGGFDimNHNFuGbed+IOEotCRxPSiAmYaZFxEXHISRdh4oVXiKlCU5tBW/gjXPSdZWML6mOrmSit23hqbXdIuJdZnEhQm4RycAHzHgRZewthcVe5HV+0at18W2RAiOh+XbNkL/u5xJ/10PErH2u75yAj5Pnmoa9qCGjV0ZrRW7odewodtFBS0SRQjbjXtc68fcxX1ru4EvuAVFjsVmYLAg26EBr0DhpbVmnyrlIIquHUFFTSEHwnpjvsNvtLVtzMlgVlvZDS/S3DEXwHnjy8N5o4NzDDjHaUmDdRG63LrbDE7c1EC/G+Fe7ePpYz6G4OuQ7MOHC0/luoLxnYmcLcZ8Wl6ufngYvvn3Bysh40tZVcYO4cecg7TzpX0yCaHLSyKnzSul3/3Ck6citV168cW9y+n3Pr3pIN1VS+lffeLH+QgcyX7vTs0IIADdB2XSU93EW7jirh+efdPjzz7ZTWLtriDoal4q3RU8imp0mc++3Fv4cs/AL/fwyxX5kscrFzQ+dC6v4rmBjT+njQesovjlvsKXAxt/Thu/v62W6wKGX33ftx0YSuknv/dFBRfA81unooP1YG0Pd6yc/PIYe/ib/+InP/ITja+v6WFWinbCInj45b7Cl3sGfqk9fKeOrSQz9jz64Q+C1EwBUucHQuq89iNaC6mZAqTOD4TUee3HSUJK+vHdTz//zyLmHaYGd+Hdz/zGW3b80POZLnj3a11qgt2flvoyROp1RUCJs7nvJZXVxNO4dxP3IhXik/uvgv55ZHkxHT0EWzfISWu4tvij6qSmXBvRhoET4ckkb77RVu2tJsNS8NZj4aveO3P6uh4yTq4ab3XVNcooXsUWdyKi1zAZSYP4jajN049RG6p/+rC55OF3v+Oanjwu99VWZQe8VVNZ1ZVNHIICnecRhJMdrFwDmuprp1LA/hf1T/nd1MfKnzNPe+95KvHWjN1bM3acVpzFhDWtwVy8mvHfvVf+NWxe1357TWi0zoyuvokpRoYoPcMSu3K8HaEAkXtAbYcQZNxr0zcHxz59X1b1I/oBTNyb/ue3dxhDLPWbv01OOiJBVV/T/SuvV5BZyihPKg8TZCZaVKtNwtA9I60M8hw2UfVhqKALRwu9ngkXTv7uv/v71375T/b0Fr7xwW3v/cqf/P1P6WHBwjv/+uM/8J/W//oNvYXffdPTM13/MiidP/yd5ujo6I/uFXmKXtk9ml4GNvhe1Fs4rJr8p7p6ZGB46pOruXHI1VvtGX/VlNy7e3vd1ep3hHvNaXcxuAXpdv8JzPc+/eiLODjJw5TgjP7nnn7YHp9kIG7+lnrIKeYFOeYB72yx2xuM3/wcGw+X3Ym0z6gyAsusnmKhzNLvoPhhKQ8uePlhjcR5wdsXGBM+G4TYu/ziYVMSuMGGWZ8LZwenYXuSboBly+LZ7ogeM7744r8mUOzNU9/m0ZL7zOyTCVn4R78/8a5f+cfnBeK5foyTRKSAg4L8XfjYpDf27//zdz7VW3j+njdv/Ine2zHzR2e++Pu3X/azuBz/5bl/9M7P8eDmHlZ4bm/XRO7vgnlTb/9rP/isfN6cnUt+4x+0cdgzsvh/fSZ59gQuf+V3dr3+5g+dweXQH/ze5/7p27+896UOm2B4wxH9ITeeHAyCfs3/UzUzsFR+GGYtOG+pPlPyo5PWLuXfZYhy6rtf+PRe47vVf1428MBkfxf2ln96ePdTb3pK1sFP/csf3HVZD5365tYb9vzMXZ/ESJ83t5/6zR/6Akq//eknvrfv819E6S2/+IGf997/eyjd/ba//NQTP3jXU11TrHb9utf8wOt+/AHZBOb+w+2L//a//DhenX/NXV994+ZzuPzI1x/58hvu+gQur/wn3/jA+Zv+CJcb/9OfTr/5hl/th8tq8QTON37vtHBY/kNt38UJ+Tf/SrfmoK8HP/zwiT/9s2/9ggzsJ2869L9968ZZnJ5t/4VDf3p66/+Ey4nw2A+0n/2fcXnP1m+2Z7a9B5fLs+/93fql78Bl+6udO2qveRMu/9d7jz35yx++cl8XC66vlTf824c/+63uxnO9hT/7/PM/8A/veB0O5j7xr3/7G28Y/xFcvjnZ+p6P33w3Lt9/+reeH95xFJebv3omjTZcgss3vvVXnp+8iqd8r7m7/saxq97zVFepWt9gLl/e/8fHdkkzd331ka+eeOyd6NVXrvvD35n5s9O47Gx63z1nX3wMl9O3/+z0N4KfweXwI63kF95wApcP3r5+84//vRvWjmBh7+4/+Fe3/r+9fQdYFL/X7ll6UxC7WBYsKIKAvYwE7B0LYEEEhKVI7ygIKyAKilQVbDR7AyuWwaEIKihSLKiIiAVE2KXacW9md4Hx9y+f97vPc/UB5p03ySQnJyfnZDIz04NwwXHrJ2yxloqh6zS21afv7sZQ+jCxqWCuRT9h/TckWZrK5+nTh9U789xvxX+iK73ErX6GuNJ4gDPvIGJbh/3XFNr2SWCjy+jRFNELm8RnainRXUXRSWwj0xVpg3+INutquLsV+/YMZ1BRKRfuP2aecxefq5OQoi2KRCC9f6DL8WV1TenYtmT5bzFC9KsHJIRGijHUsFl5gI0NS/wiiAi5xcxwjh5g4pnYf5XQ4cJ2Snkhw8zgVgnNEUs4WxmBSgVdI2X6MfEnXUfjJUszhJ+SSaOPK+ljDakUejd4KnbM8an6DGH7hcc1omNIEd60FdqoNLbwu0+7M2mGPuLSR0L5ColvGV1Ec4aIkMbNP0V/BbpZ2PyczK61GaBf6Ch89Ft4ahxtq+fohAcKYz3huxLYMnheeCaqOluGop9lxxcSdrKUYjI9odJSEEpFLnQOrKZ7rEtG3wwDKXqfP33LuUuIwWli+YjTNCNxGvqRTdrj7JKjyDfpEavwjSg4YWoK4yxbOhW3oMeiCW81d39BOk2xSUKa3sggfO9u0H/UhMX/nEmFKiDs3X8ogOQfCiDxXxWA9sR7ur0745X7hiZ/aga9BXQOK7yr4KgdwWZq6sJn7HAXxmSKH+9PoQWEPcsu90WsBTe6tSBTrAWSIuJ0N5EiJoSnEzNFusXUCOkejRDpA60D2CPrVgqRPkh060Nljz6Iu1f4phDFpP+uD/496iDcM/D/UxO+Swu3tNDzIvPlUv+yueVHaVSIlNhD2txLWtST63sUhKLdhXn8GT9+z5kQbih8p3sXV0PrNlaI/KrK39gPozdYXirI6/JJRAohTFyD82JDry5JL7LM8yW2TuHPaJitLnyyvZtHNB/cw2f3BAYw73fIeM7C/l+7Q6sa7BSdTNGQ/IdrL/nPpWyJLA3J7gumqQsfTumuUJqoF2k/FqtZKv4tnn9oF+y9pMgqSgi9Jca+Dek/9+no5Mu7ZnVGYudnxuqP4UWPS+nNF1mvzh4bXNKPniZ2mv7GvvQGemZvp13pPqkUc5IXhoX0Pzl6QVuaft1das8HMoE+k97jcwsfMUqjh4XQiaMtaJpo60jXg/bCVVnszkqwhBWXZGzb6f4EikgPu9pUSolEx2hkSlcuyBF5i5Kpoh00jCFPGwLZLRfmTA6nhA6bhNEMkRZJpjJax8iFtYV+UiiNFq/cArUezcUmQUDf7ROVJS1uRd8/XD/pVGHJKepdb+mit+n0XEeo/Lhs0c6bNglJSTwdSgXScYSg6x+EYveP9ecJ2iWQNFHTkKKEIZcUbSixdRAoi9+OT/+YqWlIULTPxZZaKfzGllB6EsKkMmJjKDonQz/pmyu8f8ASj3bhE6q/FRczBrRevzT1nvc90qjrONNJGHX3mGb6FggpxfTqM52YmWnUUxB9w0dW6CdqyIn8e/ku1ZUASMHRrALGCqkpGgoiq0p/mCtF/DeNLY/tCZ2bkV7YDpweh+x0sXRpKeK/aTjCp9+OnJIsFvrA7t4SdH+jHrsxikogjvlxFKPYIIUdFRnx5CQyRmJjGGEYKOqZ5DyWGdP8USmi7WZiTFdLAnvcqbQvL7T233KEE0aayKUQRzYyafQ9YPq/8NORucI5QIY+zhEdi+aS3O65hD7CrREnOs1IlNKdKPHPRDGMRLu7E3G7E2ENShVOW2wJka8iMtldesGao4c1SM4ohhu0xSiZG9RlNRn6KZxOcBz56h9TKvebAFaJn5iSw8ZK+AiknFEzvYsT/1oofFxVpUqcq1vx5qZldxVQExhIfxuwu8Aow0AN+TmTd53K0hBJKUfYNvk5OvRcAR545sRVrcztmjWxdOWMSrsg/aLY7jkvdDtFc2ViLhWDym6AdSqFnvPE2+Ho/WtC+TXndMmvPocxedd0n64Unqa3vgn9yZyeDr0vOqbvIkmKVFKkkGnyMqwg4ZZa/CMfiIe+hmjQSgpdISmjPL8tImsjUkUZISlrtMN9i1GIu+gVmvQnXARBS0Vff5XAPgsWUnBgVxe5mTD9KAW2THf3IOwrseVX9hJtVpChM3aT7rR6yws3sNLIRPRsMYs2qd1pmun+7VnKFw5qfH2EO4Pl9UcykwVqIttDO1R/Vk0oY+E782RES0kKh/BIl1B5I1z0YC1Qo78ELEFTEj2GViFdWVH8BSlRLrrhoiwa9BcUetRKlhYjfWeGqbHqMsJvixipeqvLidb+aPH9ISUpozuytLPwp7SEIT9XZTE+vaPrtMkCpkPZ40HS903/1GrmmGFouIxil29miAMz4Us5hHTm05d7scJLMHRW3D9ygd1xHBZVt/bT7yswSqwVa7GGUtqf1kmoqm9pEfVK0+gtvBctGksqQmV9K1RQaaPTtd3Dpw+b3kEiQ2FznKahmkKPCoUUDSW2Mv0dAOzn0R9Z6UUPkV5Y5YWlVHaVktldivCLLwpCnReOKHxxBaExF3vStV2DZ3ctY0xxu09/eyseU6Ih+LZ7CIrPp2j0xjXL7pKfAq6NeJgIR5B0dzAh7Oj7soyOpno0Sg4rKKZxYCHcKSNN916PTsp1d6pcT+TAVkylZ6TeWERCp5duJB4BKfS9cHEwyQgladkJZxhGKAmMULJXSlcsKZrE/n0syfpPsaQCbnN35CD7r7GkLCOWxNp/IVAYT0qI1+OFD+ap1IhbJkHRTwvji6UIv8KtaEqvgQbRD1nQNogRpgkXAI0khFvVr8gJXwynjmMmfEw7SuEakniss7smCOGHijFaKfzeK0uxiCVaDvt/i1I1WH9EJ0l/hifdKbnc4FCK/e86vieMpF9bnUK/RbEriqH3cdB6S7/tGZgr5Gr/DGMuskD83BBXbhFj2GNvUl30CWWBsrHwKeQd/lvUWV0RRXcSTHQOFP5arIbNOp1E+InlHf5LGKVZSXaVdsN9ubC0B7LipH8kwUSzg/DXUjWjOOUt6iLb3e0J4wCcxZII/r9b1BbFG/9cycbmTrR8DP9+LRv+ei27eyEalP7NEjf8sZTds8QNfyxmdy1xwx9r2aB4VVKSnmQlA/95u/WbsJVGp08fEEguFn7A/Y8d90Bvl6fvcGjIqKWKt9nvIOh57hAbn0kR3j4Z4asu1bMUwVLselQA+3bYxZ1nI7yb8BTR97TobzjI0g6v+P88rzVWr4p92nBYdjJuWsruoH50AMbitLZWzptLH46VNHug4eJCH057JhPWbnuAPtz2mw7RclEK/fG57rKebKO83bV+GqTN+3SqeaLyDVU6qYNK1JCvY/Tow/6hNb/vv1pLH8aHuX56NyaEPvxtdEXtVuo5JNyAzxL+YLcpRbiPnn4JK0v4fKdTlobwq/P0heg317NS0rHDjUFKqob8IXxCSjS/05vou8cYWz6dtmU9a470TTf5HihP35KjTZo8I9IU1oDe2SWvePR/qaTcf6Ok7/4nJe1RTnr1ukuhhO9H6Mr8D6VSTNnGAjzeFRO3ObracvzBlWPtyfHyBm9rd0sbNx9XfMTxdBEfunu62Tk6c7qQs7UNx4WDj1xcLN05npY+ro7e4MdxtHfwBjdPbwc3SwcR4Phb23iDnbM1zuToz3H2EiZ3cWGPttfGPzPZHH93jo03x5bt7ubl6O3oy2G7+rhs5nh6gbU328XNy5s92pbtYo2r4mjt7AWubmwXjoub51a2nZsn25pty/FytHfleLLd7Nijt7E3b/Xm/GsiceX/SIPPbvW0dnG0ZTt6sT1xq2y12X6OuOY+3hh6W3s7urmyce4tjt742uDlzXGHrvNgi1sAthx3bwdLfHkXaxr2XNTbjW3n6I2v68TxdOU4/8m4cKy9fDw5Pay3A6e7gg5uzrZebJzemRYe29GVbe26lW3jYO1Kp3Rxs8W/bbEcwN7H0ZZj6QR+jrbeDtpskbCxpLBMbRky1aeviOXHsbZxAB1HVzsY7YWlTjfZ1c27W+Qgqoowr6e1raOPl6iH/ls6WjeEF8TqIvwrriV9OXE2O0esFX9kcrOz8+J448LNR9ta0MlG289iYzXCotFju/jgzt7MYetps62dnbtyi6RMNx3srPEvT46dM26ctasNB/ClREol7Dn6yrgyXmwvBzc/9mZrV1uvmWwHa2c7NlZrN2cfuue0uxPhrhVKXqQEf7SMpnEyXIDwD+4s3CPu1o6es8QN8GLr+Atp0W+Oh4+1M1uk/V7dwu8ZR8JSrbE22dqKlbsnkbA/ZtKypnvKvocQ5aRFZDurpx//tWxxCly2NnuSKJk23bjlayzXrFljOW/+ijXze/KJe9fdv0v41pvdfEUiF482fc6MnuQLrX28vBxx1f/s4JnsLq0XDmM/sfbh4vQ5OjPoStCl0KLR6wI97WKUYttVAqNT/7IYa09vRy/vf1cp2ox1lSs6Y9dzQkgy6itM4PXvpDAVg66WYbshqoFQsrRy6jF60Jbm/zBu2tju+Fracuw9ORwvYQOYNlGoUViLsObTxtF5K9vNlSMcMxyOLYehilh5vbr0VRvXC2fzxs0V6q2XAx4MnppebKaWdVlpxhikB4bjP7LghM4c3z+GKiOZu6ONNzZQonT/GPDdV/pHPrF+/mMU/UvqP8eAnaebS3dOsTn5N/URlemlSaeywbaC42mub4EnGUd7R1f6SHxOr/scfeQjHBgrTJctAzd3euB7dWNxed1YJBYdA7El6CFG/zMP3fnd882f2bthz3zk2W3VuzimUvQYV3FTx2Lt05+uNw5crV0BaFMNsEIKYBb+mSqNAUtKTkll4DBdow1eB8SOAQv+/Nd1PqDfxYVvt4UhEepnOHOvXu2+rfMN4D/8k/gHJsR/f51pKV++eSXqWim/nf38xZvAV7Phf/WvBkkyEH1s+x/q26dBZ0fSQY//eB06r5T4Rwb/hH5Pg3krXOHXuP5QtlYTXk/ugM2vcoBI2g9GMXPBZtVvuF19DrKsC2Cm6ygoXz4HFsvUgHzDBBgaVwafh/2GcZeGQr3BKeiYEgLzbk+AI5/C4OoYdzAKsoRnsTNgTegMONI+A/ZYhsHY79nwbcQsqBYcBOVEaeijyweFDXvAZYQLPA6aCvLFmrDAOAuO2SHQabCEW5o+8OHzPZgd0AJfZ8hC3OpI+OnUACMuWYKcRRToSZpBwK8F0HzOCdjkY5jafgjenRkGm6xjQU7tI+xM4kBKP0uIMnQAbqUANL2Wg4yMPhSZ9YcHp70goNYKnPbmwOC7C+GRfT7I11fB+lAt2ON7F04OPQDzMl7D4LVlcMJAGqRlBTApCEHexHpINK6G29snwpjZ+TDciQ/J3zbBlBEzIbi1CFp2DYPAGHXYMioQnrr+AD0dP+g/ay5c61cI+YOPwoW7eaC93AiUwALCty+Adx46cLjwEEzaDHC1PBCunjoI00yfwnODL5CuMgiW+/4C26Na4P78HNgEfoNtmWthYP86yFlsBrOevYBTYdNh1MhieBbpBxtMRgKMuAktCmowuOQNJOsLwG74Fkhaaw3nfy6EoOBK0OBkwcT6CPhIWQH/7iNwnioPFugJDKh+DutmVUP14Tgo1xgLY8ProXbdcigsmghy7wZAzfZiGJizEtqGnYJBNeYwoe9kCFXdDKGLWNCxzxwuZAbD8E+tsGjJXFCxr4CzryvhouUc2GJdAgpjj0NF0lWQOdkKG/2CIT0vFKyJ3RDp5Q8ZezeA2/Ns0DlpA+1UMUTt4MOYXHswLZoPRS+mwtjT5ZBnHQWqD/xAakw/UF1wGO6uvwv3C+bB8suxAAPb4MncCzBu8QfofKoCcOcXDE94CO4lPOhr0AGNLVy4UpcP976NhXjpBMj1MIAJ8ldAcX4b7FY9AufYATDhWjIsjMuDgIm6oGTqAp6nYsCpbgToFx+ArQOWgNHWWmh/EwH1CQeh9mMYJOkfhN1NTmBpORVud/aGRYeugv1xZ/DwnANRFhMhuf8NID/IQ5T+aPjqPQP0pIdCLyUWLJVzAG3eOlh4Nga86yQg+9ko+Lr9JLgu8oTkAXzYl3ASrsZ+gbI1q+CxQiuwEydBx9IguIy90NcGlmBoIQk7I4LBdPU4mGabAy6VKjBx0UQwX+YDKzyewHwTV1CUzwWtDkfoZ/cUNGWPgoXUSrg66xU0+BbAru8DYbHTdhimeQsOOI6Dwofn4UI/E4ip3QK7X0SAtudKkDp+B/xkE6BNzx0bMk1o8DgNdnmLwbZmNhx8HQrp6CDMTeiEXuF7Qd+oGuJmHIXX7nthYFYdyL2ZBf2njYeN3BTYwI0HlT5xoFxfCc7cDHglWArTY5Rh/SBf2HyiP1gX34Z7ETdBxTAbylulYLGPJny+/gVeadwGhX5nIWKMLtiG+oL8rEnQO2EIrJp5Foal50FG00XYOEYVXPKWg862I5BjdhAkUSjIN3+B8YZ7wUU/CWZclQUldn+ozDeHjri7UHhhKawoOgGnpj2Cj2emwrm4BHg9xwEG21SD714+OOxZDb9eTYOLqefgTX99wAeg9PMl2C63gybpLBjH0YO1ZhQsFMyELd9vgs+dNhgb/wbOcfXAbu8XkCruDz80ZODF+2Ew+8pxWKsWDVMfycOKOZ+g753jMGnkNWg+OwSMOaehPPcEKCJlMPd/BCO/+0LAHimIGOgJhSfXgJtrLfA/Axxesg7uvsyCs3a3wPfxYyiTGAaXWnRgb1Iu5F/wg/BFL+GrRQoUctvhfLMuvG48BGgjCaXVLhBzbwRovboO6aNnAmQcggtr4uH6WikYp3MVlnKD4KXsKfA92xsC1qfCAFUtqMrSgR8fOiHi1W+IuNMJ732dQebMLzDgusNO1/7QuUsAYw1kwdp+EmgNCofl2Q14PGVAtIsr7LefAfqUOYQ9XwR6bwbAPZ25MNp6CjxwLwG94htAOXfCcUgDaef3sOF1Cqi7LYTNquVwc2MYuFsvBiezGkhazYKVptNg+NMsmNRyF/q6WoKF3nvYOeEMDLucD6kTp4Jc1nFouIRt1Fd1iHZ8D5oCP1CS5GK7rgPGj1KAfSIJrqRVgK6FAlz9Pgf6vCyG7XdK4fCrXDg3MBuK0naA3JaNMMF0IGiCKQT3a4a3suHQT9EWDhhFwa471fCyUwucRl+HgIjJIN32G25Sx8BhizEs0ToNxnc3gM43Ep5vSIT2e/uh1/IoYM88CcfXWkI/dAm40/fDQzYLPF6Hw4Pq60BZdcByTh9gyTrB3szzcDmnFFaZLoLhP3vDfs98SJeZBTmGU0CmKgBq5j+EFeN+wLOi+1DfZgSBttVw2LYSXtzRh+MH88Fv3RNwfFcAzS/7wq2ZBCwYtABMfSyhPLsDXOMK4fwEC+g9rwmGGswB67u7YFznJ6h71gYagUXgFjsF5GoKQPA8Cly31EJmZyHEy+VCoIU3OF24DI9cj4KBZwAU9tkCXx+fgXFeb+Dag1uQBaug9nIv8L41Cj5stwLvykjo1V8bdgxSgiC7BGCNGwDJ23yhs/MOmM3nwws8dze+6At7bt2Euwd/gf5pTWhxzYeEgqlQedoMrp6+Bo8f9gbVCB1wWzsZtM0iIKnkHTxj3wSnTWfBQOsI9LF8CJ2KS+Bt+0/YN8sFasO14dOTMPh19QzweWUwYcoD0J1hDdPV54Hai/uw45cC/FyyBXSHVsKaq2GwImkvmGg8BC3TKsgpfAaKgw/AEPcb4LjfFsZssAK0mgfBfZSh/Vof+FXcAZNJHfzDg3qLh/B6kxXY7zsMcZP48GDgDbBedxjeriVhVWghVBqowGuPRaAz9DVkDEoFde0FsL7tObzYlgjHTHLAOPwHmMn8gg9bL0KExlSYfkED7OOrwLT+LISMmQ5FdYdhVa/jkDTpEpx53hscpRcB53IzBO8+BbuXHYTvZVNBPe4KBIQsgcTH6mCYXAVVC03hrfdMsP88B34ffQObnlhCgP1xuHV+G5h+SYPxu0eC0S1TWO8qB+pa4TBjYShEvPsIH449gcU/DUFg9gmGKhdBwfpISPgxHipyC0C54DG82nARFhaEw865m0E9fBZob00AFetdoLUsALjaQ2AupQq7x8SAPxEBp+++hw+vAuDuzDwY094AX+2xDsRRwEkfD7PjL0F2oCIcX1UFmq9twPHtaziUMBhOj9sPDiVjQb7pKsxLZsOKxCJwD7GBoMCRoHxzIpzq2Af9zOpAvUUOrmGfxi1oOZwYvAqufT8HIW+ewYHX1jBgqgS+ZjKEpqWCZ5MLzIjaBiE3zoDTxI2wQNMcYHITlIMf/Go3Bdb65VDjwWW6uIb0Ey30gc48b9pv5yYu+Ea75VarHvrPonGoWvMMOh179LbpNNYIeTeVTj+szXGKaB+PvWHXAxIA9L4iX2rmrGPkoa9K2dmd9MrjG0SYiHaKx44f+Jh+58nA0uP29DZ0Ub77c0T7kT6iUXdDBNlUCbrWrvRczuk8erhyQfm5y6EobOaKwzXPTdGf3nkzcqV2DzGedZiYMunnmdlf+MiiqvJIXysP0prrZ3CokY/K7HapbNsUQ+4Mdq3v/46P+n6xn7K6fC/hvbN/ReYLPvqx7/tIbskesvrL63FOpXxkff+j9YqvVsT9wz6D5t/jo6SKSebv02OI0LbCIoM7fOQSEGpx8tBBQjniu/O6a3z0i98ZN+TaPuLrQs/xcefx9Y7ous++Y0CklVVMbEznI0XXmIjJkltItYrfGXaH+ah3tq7WarP95Cpz1VJWPB+ZNqzYy+euJB/qO+dkR/LRgPanN0c+iCVrdM5cPBTCRxmmGz+9q+ASq/aduJ+4jY8WxZ9o6K/GJQNWbSduePLR7InVps0josmGqL3Tv2/hI2pNX7Q3Yg/hU+z22dyGj8Z87uN75MUB8slGqbAacz6y0p1p8LXxEHH2poP+LhM+Ojo9vDikLpoc9uKXxsrlfBSVf3KekVsk8Wzv5t2zFvDRdqn3mdLbuMSBqu2xixEfJZw+/a5z3wFi+mYf123TMb/Iu3XQpl0EOnnZuESfj1rrRiSOX8glXgfWcuaP56NNch4o4MYBcodNx9s3o/hI/5y8y9uvIcTb6hEdR4dj+VNuQw6rzyZjXrwsDR7ER1cVlDxDpu0hFCXfn9ypykfRxSURcf1cCTNdgzMZSnx0/Vzmcp/loUT/LH2F3zJ8tMz7fC1rTjihX7nslzuLj5Z8q7CY8TqaEAywvSz3i4ekzPfN4qaHky3JcZYFX3jIYeXSh01L4sjiMzOnnWrhoX06q9S+ySaRdpXSLhcbeah8aoJBfZkH+TX5w+RXdTzUX63kyuDBSeSH033zdd7xkMsyrVOLkncSGpNVl52s5qFIx7HbrFTjyaHc81LzX/KQecTARdGn1pFaE76qKzzjIbVDi+0PaweSB0+vfNFRxkN9zudZNdnMJXQirK3kSniIbyszS97uALEWhjUZFfHQVsnUl28fuhKlRO61tEIe0lNVRvsE8UR1xfNmrXweyszYdrskxpfQ1Jr69CXFQ341Jp+zh8UTvV53Jl0mcXvSPWByQjR5Svuo7+WbPLQ4Pb7qYfUuco7d47SX13nIcrpydmG1PxlifNRs/FUe+rIxoHGBajipHGdRdPwSzv+8c5D0lHjipea1qQszeEj6cKRuVmIA0Xnv4BPVCzwkbzK09q1NDDHOZNFr2XM81FA4eOXOe5OJrAXrI8ec4aEpObbjP05MIBapX+jvdoqHkn2TrJe830vKV/nefHuCh04v588qmLSX3Gk6MzPoOA9d/DQ+wn9NGMnOfzh5QToPrVtn5v+6JJ4crWEaMj2Nh2wHB3HPqqwlvM4se2KaykNjNTZR/Cvx5KNZwXbHUngo5ObkXRdUt5DUS0UfVYx5Z1xu8O1tSN0hHOJyMg+t2l1jMruKS4YlrPq+HePHBhuCbEf4k96WjfU+GGdu35OzhBdOeu84segQxpEfTYdPHBxOPrCfY/YZ44on8puKj8QQyKLa2BGXP+zE8ptVEwPIXazPXv1wfZxy7E06GxOIibl6rCaMTZ2fnXv7mUNsXvF4ahuu/5zHV3QLUneTqkMMTDRxeydPm9Vy3TGe7FuyLCkCy2O4YPDMsE1c8sK9kQuGYHm5rvWsXPkkgWyKm3f4xWkegsje5vYXYogku8gX987y0NWG5lzdrCjiVYrWnA/neUhQV3DE6jqH3Dvv2oCJuL/mWbatD/0SQEz16590Efdn6Ozhp0bIx5OFglhFc9zf44Y777lxxoL8UPAoc1oWD62/GRP4faQzqbz6fvG8Wzx09nu7xty5ceTKFdXJIdk8tHSf3XPnop3kLdki95YcHtIsiR3/K8ODiGlOD4m9y0O3vRTeTil3IUaOfDfY5j4P2Whs1pAq2EVyPlgE2D3koaf6te/Ch+4hJuksaTxcisfTbbKi7HYsaTHa4LLkUzze9HlH9B/GEOuu6PU99oKHrmzwcg1zDCOozq2mTnh8XT267+CjNyHktrYKygmPv12TiuP8huwlLlRsSEqu56EfL8qWRAfEkHbXo8bJ8njo1sUqsxf5puTP/sY30tp4yPDLydm9j8eQM9d/iPL8juUff2F6+zMHcuGmn62+Aqyvkeucanmx5BKZVL1MaT569NpS4bnAmyjPXRozHNub84lxP35mx5Lyw5+b52F7dEUpQ++iqxdxZPXO14cHY3vYmbxx4rt9xLZSgeU5Nk6/Xr4suiaMWFq2dkKLJh/ZD1kxPeORDXGtTibBRZePHAbHOWs72ROOMfwq9jQ+Kr/2MHRQJJf8kW9hqojtq9sPAbK4EE0GRsgu0VnIR4vP+Ey/2CuGbI3oJbfLmI9Oyc4+uTPdm9h1/GfVoHV8pKxhyD4WG0Imhj4Y8M4KXz8u9+nKDfuInRNfSX505KOlTqzz62eGEVZXWW3qXnw0wuCqrPrTENLycMCkg4F89KDXwlk3tSLIcakd/RaE81HF7plWUte9iS9oT92EGD7y8Dy6qrEglAhddu/nqkN81BxbEa36NZp8GXM8LeM4tv/eI2sTL0aRLfb7dBZl8JEc+6wRmb+P0NxgzVO7xUcTP5/JTxgfRhy85TRtfAEf8XaW6Z+xjSQM57ua++L5tundrPe3pu0j+905cqHzFZ6PHsUunxXhR1TGHNuRW8dHEQ+tjHKl1xAtHtHj89r4CKaL/AQ9+3vxa9smzGaJt8Ca660S3juOmf8Z+xuPqT6sllFXkh6g5PsyH3xMC6iurbJ+4nvMxUK/5DGl9Hp/UhJOd2q+vfCpN73qeemjFuchzuw5xwUCiip6pjU2zINEAofMuZ+TblI7SzO+huzIQo/ml/n0XX2NSq6uyW+e/BVBzMetwQ+fUyM+aW/x74sx9MrjuT2nUq79kLNq/YKgZlXfd32fU9v39h1xsgxj/7HTzW88o8quFiguvkRjboypxTPqlpLupIWxGMMg31KJZ9TIORqDkj0wjokJLzr9lHox/ESS8WqMV0qazTV+St0dFX3WbBLGhk750748ofpVHXW60o/mT3eeOvqEWraxcLXtlw4EpyNmxM1/Qhlrx16zr8T4RuaM9qYKqjrGvJi8hbF79LySAxWU/5AXrdZHMU7JHjjcsILaZbZA1YyLMXcBv/ZTOVXhVFdy0AbjGr3pagnlVHzwqdrRCzHe/XJvgUE5FTpfZo5AC+MYzXFvP5VRb7Ivv9JQxvjbovEu+8uo59WTF0a3tWN885C9URllOLb68dxKjBP5CaVNpdT9dP8cg2yMVV4NOnGolIocXZMfnIbxDZvVHxeWUpPDnoyS3o1xc/h8jc+PKUWdwWolLhhnDvRZsvAxZTJoRsWLNRjrqcyed7yE2hB2dZ7mTJr/NK+XRAn181t/o2tsOr/fuDSrR9SldoOXIbIYx+yXYuU8pKJ/r7WI5rXh60eYjWM/pD4tU0x58ZTGO6IG7iimxueq5FhlY1xa8fBBbRF146XP+FEnMI5RnWA4v4iSKE1+pBGFcfMwB7/TD6ih28IKzH0w1lvk6KL0gKqdemFxiQXGOfNPsj3uU4ZPliduXUDz/a5GP7tHjSoWlGzUxdh9M3GDuEct7pXq4zcIY6tphw+lF1IxMwym3WdhnJJloq9YSBl92397xedWnH+U73avAqrszGAJhac0zosOqLpLaXVmnf5+B2MoX6W94C51Tk1p29AzNA4lIzPzKb1r/aw842m82ClJLZ/qSF279sd2jA2Px5jsyqOoWcMOX3HAOGXrt5ttuVR2R3To0TU01h593yqXmiX34GyWAcbsr2uDS3Ko64ZnxrO0aP734ioih5po9PDA1v4Yc5eS2Wsp6vCv8mFsFl2+4QG5aXcoxUXLF7c3tmD83SBxYDblyIle3VGJcUrlCvvvt6nAoLV9RhZgbKXL3lp1i/o0ptg78BLG3LF1+Tk3qetDtJVYxzDO8byy4OQNKtv9ekBmJMZw/gorKou6TvJHR/rRePr8Fu/r1Ev9ZVOibOn8u1x6b7pGvbbUjLm5CuOa1OqNi65Sy8onHu+N6OtvWf5i0hXq5XcVzz3a9PULvm1lX6b0rzWO1RuCMXtz4oLel6iMyWEvf8rS5Zdvcf6RQV1xWqHM62jG7fFbEvXyAlWSrGUh8x5j2Pm+kTxHqZ/QtplXjnGOqmFE6hlqSGJt4KkcGktMWrf7FFU2tTBUNwNj7jP7TR4nqBl9UxJfHaUxZ3HkxnTqTd3qjHN76fL7275bnEr9HLtCNzmA5j+H5HgeowZHT9l7bQuNV69uMT1EaX9vPMFbT+MdjzfPPkDFaJc9WryYrs/ZvT/HxlFnLjQXFk6n8Xd2gP5e6szErX05Y4W8xZTBYdQirwbNUYNo3JgnqepP7b/UT0ZKjsajtspLWVFDfoz5OqIG22WICWvjuyHvBuu8oak0nj3FqGoXmpC0I1MFxyHAzbubXhKPHl3gEV9G03xEv9zkw6iub6zk/U/Yz4E+JZWZqejcpWJ/7kWMc1il5pEn0GGlo2lDvDHmVhqGbjyDriUphMbOpPFa/hbNC8jskJV8DYtOn/gh0ScTJd72+8AqasL90+tdx5rLSDI2ULE1ronu/z2vJ1xFJRt/2p3fiHHO2l3rZa6jo9Wbzmpr0vyWKb4vsV3XdjJwbW3E/T10xdxzN5HE1lNpLndo3Ov2Pf/byEVumsuYPRiz6yb2nZuNpNZZZCeso/lqD30FCu1Nvj3p2hiMDWPH97fPQaiukRfa8Rnbn7iQnQtzUe6BVz6ddzHWK3rkOiYPjV0SrjR8P8YrC04+l8xH2gb8gloOxiqTiPw3+WjP7gf2i6ZhzN3mNPXWXbREb5j6UnmMm8vGzogvQEH81p31rxowHjTq0ZZClDbbSn9YBsYxdo3fDO+hU+sq0McQmh/SkdP/PtrjJc83XIsx94vJuE/3kebSczFa2hgbfpOYevsBKmuN75vCwhi0hzbtKUJqxKtRyc8/YXvH2rjKvBjFXLonPfoixjnkQ/txD5FuycHWCTsxtlr0dMqXh8hn6XHerY00v2Bydu4jNH1R3dHCyRjXPL7B2luCPq621zXuhXHMwBx508fo6HPBvtUf67F9H6Hq3LsUBcLD5BIK49L43jc8SlHv/Dsvc5Iwdg8/5vSkFP0cOPKspjfNL520a2oZkjt05TwYY7xopH2vxDJkasCpX6yFMfdhjeBbGbKSaN/PksHYwea55fpyNC69xmZ0bR2eD/vJ690sRxeuVflduYOx1VwVz0EVKG/0QfuzhzEe1Ogyxq8CrZUZ2Cq7FWO9jJ/GTyuQUt9nr4rMMK7Rfceb+AQ5XTdmgcpHRJjPiXWWCCL2X10uCXofkZEFLGqgogj/Jwm9YOVHlHXiWfip4H3EBbcVsuD+ES0bbeLU8MuauKj85rcg+iPq7L1+mWZQIEkW2MhC5kfEelm1yCE3kvySu3E4lH5EfeIXHx2KQgmDL9KfBfyPaI1O7RApbhDJPRjeG1Tq0Oqt8h52ggBC9ZP9L4FuHRq1K3tMLewltvTZ8UZgXIfKWS2usRKuZMwRe2Vwr0PeR0weefyyJ6fcD/ohiK5DoVIdx3Lv7CA+5rF/CzLqEMf24biBQe4kPEBNgsd1aOieADlPLpf0HTLmk4Bfhy5+P+oyNieKqE8/IgUq9WjSsg+ryoMjiGjt+IGgV492tOld//Q7kjziNUkGVtYjcgrHiaIiiMKIOWxwr0c+AX3aONQeUmprx2dBdD1aWzw7zRUiyDdSpAZk1iOFpTXT38B2MlJN6YPgcT2SThYs8IDd5Nx9sb8E/Ho03X1bacCOUOKe5Y/hoPIJSV594xtrEEHcDFjQF/Q+IV+JxKUruMGEmyzvo8D4E5qwWfCiOSiaLFMlqgVun9Ct6WMOnA1xJ3tFzm8XRH9C/NO2sWrcXaTBhMTXgoxPaFr8hsgaw12k3c/FuP20/h7OlStBxKojLWxo/oQUzHdrnkWRpEzm/D6g0oDMXq5LWoTjhh9fbsuCXgMa5DI+8tydvcTWYQdVYGUD0tvq/7ro925i0YSOYeDegF6dq5ztaxRNrp60fijENCBV37wwCWofudTAWAsyG5AlEhBSnY5k2fCLzwWPG9BV9xjVOoMQ0l9qFU/Ab0Dp1b1rDGS2EOa9OK8Eyp/RTYUR0+/LbCDWFp39LdD9jIYRI72Hs7aSVbf2vxAYf0bJWuEOKoKt5BHOsVHg/hkZGIeXzhdgP3zAru+C6M/oe37eAb/fgYRxsVS5IOMzuju+lacpsCHnbzQqFzz+jNQbZvGyBM7kG3mbbwL+Z7RRccJBSaMd5Brfa28Fyo1o8JasBNvcPcS7tT9aBLqNqKlQL4r/25Yc9Z6qEhg3Ip+FjaQDCiO/3jRpErg1osaaNc3pQWHE0+gk3P+NqCXue5RMqBdxSH20OmQ2Iqneg2z3dTqQRxYkvBY8bkSeDfeG3gnaR/je7WwQ8BvR793JF2bc2UeM/3ZoAKg0IY8NN0/Hbvchhn1V7gV6TejlPXfHmNwI4q7y1gaBcRNS+r2uYFrvdeSHXVUTwL0JzVPOXf6MG0yeDalSh5gmtHFjZ0J0oDcZKuFUKchoQkHW6gXDgvcSMxY6j4PSJrTmkuDyMdZuoiNm3gcBvwnHJasLy8GVSPhy7pFAGcexjjpsw9Bg8vX91a8EujxkK6dWlAsBBH/AnFaBMQ+tOpeQeVrgSfTZFFkvcMNx9x3+Ja8va8legmN9IIaHWPcVN0Vxw8h5A0+8EeA4/hp77lMZ8CdSg1WHAI6b4zaaWX2TWEnexZE4NPNQn49TLOYZ7iQlorZ1CJT5SDqWP0P/pzF5L/LDcNDjI9M+Xq3nd0QSCZNDOgQ4bpx77/kTIxRJOC0780vgxkc+/olD2yU2k0Z3v78VROM4sc6vvWy7HxH0rgb3Px/ppwceGsxyI4+99xsKOE67dL5kKW+HB6GfX/NVwOejDbvcWdOkXUlXK067QLkZvVQYuvhCUCS5blt4m0C3GdVc/pXvGHyQHNjrV6fAuBmZJxRP/k0dJEKWP5IE92ZUbPY+JxRCiPriVqx/zWiIz7Q7bwQuJOelEgsym9HnMR8vBqNYcnrFcRaUNqOvyYu2/tjOJTo7X/4Q8JtRjtMzd2kpP/JA5y1FUGlBmxVdwp5w9xEW7R9+CHRbEH9qp+0P6ijx4tBTbH9b0MWVqu5+cIg4ZKqO7V8L4lW/q/3eGUWMMdH8JYhuQV6es6r0IJZYT8xWhcwWtJslyd0anERkHRv3TfC4BdnvTT438TuHhCeR7QJ+C/psfuooFRxPHA/fowQqrUjDvDPWiZtMSM7die1/K5pEJX/OE8QTYV9IgcC4FXlOmBBUx/IlXqiP6xC4tSJrpWDf27+CCWJmfD+IaUXjjSSIIglPsq+NaT/IbEUSI1onhXDjyFmrf38WPG5FrVXG04MEu8kDF24oQnMrKjDSW7lKsJPMqN32U6Dcho6O3bTbA3aQwZbn8fhvQ/2zspCFIJY0sz+pBCvbUHbIHo2Q4P2E+teffcC9DT182uvuLeASN3XXY/m3oVWnLuscRQnknPLXUpDZht5O93V3Ct5JrH1wuUPwuA3pq1IqMyW2EYOuZuLx14YyV1+ycwlOJNozJvYHlXY0audgy2nf7IlxexZi+9+O5q6q8vzICiVsru6vExi3ow0Rl284CiKIGh8prP/tyKQ17/ClnP1kXa4bXxDdjjy1ZrbKGx4mpE7d+SDIaEfzt/eisgQJZLWmykAobUezt1R52OYkkbUGzcrQ3I6GrtmpGBF8kChbWqUKKh1o6nE7D46UFbFNU3oA6HUg+YkjS0qoA+Qy91eNAuMO9DxVWtpTIoI8Y2LJF7h1IFXbB70/UocJVZWPAyGmA8XwM3YUBO0m4gweSEJmB8pRohTkjJJJcvDiYVDagcYtHP1Ta0ciGbHtRp2A34GkHJu4WUEJ5D/XI7rWGayE6wwfKBnxfqQVpuuTkpI+oW3HxwnPf5q/6LD54lYqH43ZMx6aRfc1Ur703N+4f7M1RPsZxTWbNnbU1R+ibVJcBi+3jsoue0qxv9ZUyp0Ymi16pIHBr5s/0M/3KeWy8vrT45tHinhDBv9NZ9eFIU+pp/aZx96HfSRFj6UxeH+//ZZ3nlA1BuPiHdWkRPmBwVsNzdtj/YR6GLZskW5lX1G7azp6+NPh4XpST6iZiiFNbXOqRPXPYfCLHE2XnaygrBJWhRdeYovypzB4buKh1wsrqDhuwZPl60eLeC6DZ7+9VVtfTlWOz0oaHjBGxFsx+N3VfTdElFMo8/H1fkX9/443ZPD+j38ajSunfF+uGTtqwwBR+9kMPtExN/F+GSVlUudAZowQy4fZ/nPnNtqXUc2nQyYVjhghlk87o/0Xv++RLqPsNkh33j09RpQ/h8HHeNWOSi+leku2B/GclER8CoMvvZow2rCUCtZpP3ZjajP5VzyXwRtuchl08zG1i0g6p7W2l1g+DN6qqvhCcwk1KiP8SNaY8WL5MPhmLVdZzRJKRYBMjHUHiuXD4HOMndQ3PqLUHIpux95SF48LBp9y6N7X6IfU5LBkB+Otmn/H17Qx5KPjHZ5XTEVn7dHPXDFYxOcw+BzuigdtRZRdzCNks+KWSP9SGHxm7QhyZBHVkLugynbv6Oy/4rkMfmX7kQ2rH1DvnuRKvSjTEo8/Bl/K5qQE36fkf7wKprK75Mfga1QkIs7do9YtWeMZ8+oveTaz/MF1ys8KKbvay+lb3quI9Y8pn1PueoICasZKleS5x4b/HV/Tymh/6rsPYwqoaHPZmD3VbLF+MnhusfP45Xcpwn+Kda7SwNl/xacw+Jjh7F8e+dRME83l4f4tYvvG4JtHfFu9P4+Su+sxUC9qlFi+DN5K96lWVi51IL3PoOPcCX/HGzKvXxoY9DyHajev333AUWH2X/FsBl/zSj+2kaJaJ6VvNPER6wcweBiPx8cdisADRXuy1uy/4mtaGPprHm2yiaRk7liuW6s0TCx/Bl+zZKZL3C3q/lnz+ikzxPbxf+JTGHyK/rP5+TcoBzPd5eMC+/4dz2XwVh8iy5uvUy+9Jj2YdlBsv6wYPFsGyapdo9ZuKrQ2lxDbv/+JN2TWX+3Ac6Mr1Ju+3x++3KT9dzybwXPTeVM5lyj59GjfTYH9xPJn8n1y9BQyqNh9U0OPrdf5O76mmcEP9ng95xy1zP3Zh20hQ/+Oz2HwORO/rPM+RfFSWycv+KWd/Vd8CpP/fXPXsXTq7O8xHVkSHcRf8VwGD/69D4ckU+/lgwLHcMdl/xVvxWzfU1m1mwepGSd/xJtEjRWPL2b+X5mnc6KpIycrvgQOf0P+Fc9m8ipOWjXB1HvDl71Q7eDsv+KhGf33feH/A5/DZ/ARPv1VuKh+/NEkp3ti+8pl8Nz4dWbsGFT+tVbGvKrLv2LmfzB29OJENFlpw8RbKeL5ARi8YV2EhVEKWvO8ZWNOH5ZYP3iM/BOeXLQ7jsZ2Zvt4DRD3P5fB5yT3O5twGm0fs6F0/1Zx+w2Z/OtHXsXnkezYyoWtDkPE8mPyMjn6DRdRwKwHxgZ9eovtfxNjfC8om3XwEjp8rJeZxcSu+ZHB15Sd6si+gp6veHVi033x+LNi8CkHl2/4dA0NH2ZByDiK62/I4HMaFCogC01sOnomanij+DEABm+43mLTpJvo5cLsmRv7jBTLp5FRvwtR97fcRh8cvo7nxvQV14/BG5KsdbtJVHF+Q2HZgi7/kMGzFUJn3LuDauZ/zHDI0RHXr5Fp32fE1lOoUyHV+NnkLvvO5DVD9g3MRa2yOiX+fLF/U/OZMX+NDBp/NhdNTpo+b98psXxSGDw3XMm6LA+lXt1R7HxUUmxfGXxM/8xfnHwU4bl05GndQpF8DBl85qTQ2bF3kf/1TpOtoWL7zmbyqe8/aBage9sdP9RPEre/pqGHV9l7Z8XaQuQ/gdDe87jLf2Lw7j57VJsL0Vv1Ix+i+nT1P4NfOW9nVMQ9JD031l3Friv+YPAw43PGnfuoTPvTWZPZsmL5MvmvVRs2PEBugpR1Y1tlxfaXwddEEk3xRchR3WzlXE+xfan5xPB/zNdW6hejs2/Pr4iaIvaPcxh8zazpu0qL0XVVk/V3l4r7N4XBqzQX/nR7iMrHHyjwbGwR2R8rBh/zJHP2pUdoSmb/r1oC8fg1ZOavE/ReU4L02o2sNFXzRP3DZvDw+v2FjhLUZ99tTn/1IlH5wOAzrzgPTXqM9N4oFTUWq4nlX8+I35ZbTfcoRbErmga8OvJNbN8ZvJW1vc7dUvSpgRiwZ5DYP+Yy+HpaP8vQ0OYTNr3VxePPisF/O1+80akM7Rhw4uujQ13+J4N32GCTRJWhrOyFq5pOds2vDP5Gb5f5/cpRw60Ft6p3if2jmjqG/KoCm++Uo3aplUt+HBH7NzkM3qribUu/CnSDUK/YVivu3xQGr3LH196pAt33a8l85NpH3D4GrzfJb3VeBdqYLXPdZNYg8fhm8PVPR14d/AQdrYlpnPpeTtw+Bn/fIy/K4wnyeWYvX6KpK7aPzPIHHqt58AQdr1RQi2CL/Udg8CnTZS9qPEXr79nucL8jjvtrPjL08/6arwFPEd/Qgtd0Qezf5DB4q/Vvsp8+RVWc43JaigrZ/wdyf/Q1ERICAA==';
