// sources 840917741
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
//     MS_SSS_SLOPES       1        from depth; 2: from normals; 0: no slopes and elevation, where options.flat is 1
//     MS_SSS_STRENGTH     0        1: with strength
//     MS_SSS_ROTATED      0        1: rotation or jitter of ms_sss_shader
//     MS_SSS_HALF         0        1: X and Y lie between DOWN and UP; for kernels from a radius of 16 pixels on
//     MS_SSS_HLSL, MS_SSS_VULKAN   defined: the language, where it is not the GLSL of OpenGL (MS_SSS_WGSL: by sss_wgsl.c)
//
// The engine defines those of these functions that a step reads; p is the pixel plus the viewport's corner:
//
//     float3 ms_sss_fetch_color(int2 p)     light before the albedo; not below 1e30: masked     X, Y, DOWN, UP
//     float ms_sss_fetch_depth(int2 p)      along the view axis; not > 0: masked                X, DOWN, UP
//     int ms_sss_fetch_profile(int2 p)      index of the kernel; without one: masked            X, DOWN, UP
//     float ms_sss_fetch_strength(int2 p)   0 to 1; 0: masked                                   X, Y, DOWN, UP
//     float3 ms_sss_fetch_normal(int2 p)    in view space: x right, y down, z to the camera     X, Y, UP
//
// BASE and the disc read what X reads, RESOLVE color and strength. At half resolution X and Y read DOWN's target in their
// place. Without depth the second returns 1.0, with MS_SSS_SLOPES 0. Depth of 16-bit floats also wants MS_SSS_SLOPES 0:
// its steps are seen as elevation, even where slopes are from normals.
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
#ifndef MS_SSS_SLOPES
#define MS_SSS_SLOPES 1
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
#define SLOPES (MS_SSS_SLOPES > 0 && (PASS || UP || BASE || DISC))
#define NORMALS (MS_SSS_SLOPES == 2 && SLOPES && !HALVED)
#define PACKED (MS_SSS_PROFILES > 0 && !PYRAMID)

#if MS_SSS_PROFILES > 0
#define KERNELS MS_SSS_PROFILES
#define fetch_profile ms_sss_fetch_profile
#else
#define KERNELS 1
#define fetch_profile(p) 0
#endif

// Float4 of the constants: before the profiles (HEAD), of a profile (STRIDE), of a pyramid's three tables (SIZES), in all.
#define HEAD 4
#define STRIDE (6 + MS_SSS_TAPS / 2)
#define SIZES 49
#if PYRAMID
#define COUNT (HEAD + 3 + 3 * SIZES)
#elif UP
#define COUNT (HEAD + MS_SSS_TERMS * KERNELS * STRIDE)
#else
#define COUNT (HEAD + KERNELS * STRIDE)
#endif

// ---- constants and textures ------------------------------------------------------------------------------------------

#define PICTURE_SIZE CONSTANT[0].xy // in pixels, of the picture at full resolution
#define CENTER CONSTANT[0].zw // of the projection, in pixels
#define ORIGIN CONSTANT[1].xy // the viewport's corner
#define PIXELS_PER_MM CONSTANT[1].zw // along x and y; perspective: at depth 1
#define MM_PER_UNIT CONSTANT[2].x // of depth
#define PERSPECTIVE CONSTANT[2].y // 1; 0: orthographic, or a light map
#define SLOPE_SCALE CONSTANT[2].z // 1 - flat
#define GAIN CONSTANT[2].w // 1 - fade
// of X and Y; those of the pyramid stand in its file
#define ROTATION CONSTANT[3].x // radians
#define JITTER CONSTANT[3].y
#define FIRST_TERM CONSTANT[3].z // 1: the term that adds the light itself
// of a profile's kernel, which begins at HEAD + STRIDE * profile
#define TOTAL(at) CONSTANT[at].rgb // sums of the weights
#define RADIUS_MM(at) CONSTANT[at].w
#define SCALE(at) CONSTANT[at + 1].rgb // of the term
#define DEPTH_SCALE(at) CONSTANT[at + 1].w // to units of depth in which weights vanish at a difference of 1
#define DELTA(at) CONSTANT[at + 2].rgb // the part of the light that the filter leaves where it is
#define SPLIT(at) CONSTANT[at + 2].w // square of the difference of depth that DOWN and UP do not cross
#define ELEVATION(at) CONSTANT[at + 3].rgb // K / 4
#define MIXED(at) CONSTANT[at + 3].w // bits: channels with weights of both signs
#define ROOT(at) CONSTANT[at + 4].rgb // of the reflectance
#define LEAST_SINE(at) CONSTANT[at + 4].w // where 1 + K / 4 sin(theta) is 0, or -1
#define TAP(at, i) CONSTANT[at + 5 + i] // weight; offset in mm. 0: the center; then one of each pair

#if defined(MS_SSS_HLSL)
cbuffer ms_sss_block : register(b0) { float4 ms_sss[COUNT]; };
#elif defined(MS_SSS_VULKAN)
layout(set = 0, binding = 0) uniform ms_sss_block { vec4 ms_sss[COUNT]; };
#elif !defined(MS_SSS_WGSL)
precision highp float; // for GLSL ES
precision highp int;
precision highp sampler2D;
uniform vec4 ms_sss[COUNT];
#endif

#if !RAW
TEXTURE(ms_sss_input, fetch_input, 4, t4)
#endif
#if UP || GATHER || RESOLVE
TEXTURE(ms_sss_sum, fetch_sum, 6, t6)
#endif
#if UP || (SECOND && HALVED)
TEXTURE(ms_sss_half, fetch_half, 12, t12)
#endif

// Each step is a function filter_pixel. Those of a pyramid write a second target, ms_sss_other.
#if defined(MS_SSS_HLSL)
float4 filter_pixel(int2 pixel);
#if PYRAMID
static float4 ms_sss_other;
void main(float4 position : SV_Position, out float4 first : SV_Target0, out float4 other : SV_Target1) {
    first = filter_pixel(int2(position.xy));
    other = ms_sss_other;
}
#else
float4 main(float4 position : SV_Position) : SV_Target0 { return filter_pixel(int2(position.xy)); }
#endif
#elif !defined(MS_SSS_WGSL)
float4 filter_pixel(int2 pixel);
layout(location = 0) out vec4 ms_sss_out;
#if PYRAMID
layout(location = 1) out vec4 ms_sss_other;
#endif
void main() { ms_sss_out = filter_pixel(ivec2(gl_FragCoord.xy)); }
#endif

// ---- a pixel: its light, depth, profile, and the slopes of its surface ------------------------------------------------

// Pixels of the picture along the side of one of this step's.
float side() { return pick(pick(1.0, 2.0, HALVED), 0.5 * CONSTANT[3].x, PYRAMID); }

// The corner of the viewport; targets of half the size have none.
int2 origin() { return int2(ORIGIN) * pick(1, 0, HALVED); }

bool inside(int2 p) {
    float2 at = float2(p) * side();
    return p.x >= 0 && p.y >= 0 && at.x < PICTURE_SIZE.x && at.y < PICTURE_SIZE.y;
}

// In perspective a pixel shows a width in proportion to its depth.
float relative(float depth) { return pick(1.0, depth, PERSPECTIVE > 0.5); }

// Pixels a unit of depth along x and y; perspective: at depth 1. A slope is this times the change of depth a pixel.
float2 focal() { return PIXELS_PER_MM * MM_PER_UNIT; }

// (x, y) / z of a pixel's ray.
float2 ray_of(int2 p) {
    float2 middle = (float2(p) + 0.5) * side();
    return (middle - CENTER) * PERSPECTIVE / focal().x;
}

// The area of a surface over that of a surface that faces the ray, at the same depth: |(slope, 1 + slope . ray)|.
float area_of(float2 slope, float2 ray) {
    float towards = dot(slope, ray) + 1.0;
    return sqrt(dot(slope, slope) + towards * towards);
}

// Below 1e30, by its bits: compilers may assume that no number is NaN.
bool finite(float x) { return (bits_of(x) & 0x7fffffffu) < 0x7149f2cau; }

// 0 to 1; NaN as 0. At half resolution UP is where it counts.
float strength_of(int2 p) {
#if MS_SSS_STRENGTH && !HALVED
    float strength = ms_sss_fetch_strength(p);
    bool number = (bits_of(strength) & 0x7fffffffu) <= 0x7f800000u;
    return pick(0.0, min(strength, 1.0), number);
#else
    return 1.0;
#endif
}

// Where kernels differ the last 4 bits of blue hold the profile. Those of 0 would be flushed, so 0 becomes 1e-30.
float pack(float blue, int profile) {
    uint bits = bits_of(pick(blue, 1e-30, abs(blue) < 1e-30)) + 8u;
    return pick(blue, float_of((bits & 0xfffffff0u) | uint(profile)), PACKED);
}
int profile_of(float4 c) { return pick(0, int(bits_of(c.b) & 15u), PACKED); }

// Light and depth of a pixel; alpha 0: masked.
float4 texel(int2 p) {
    if (!inside(p)) { return zero4; }
    int2 at = p + origin();
#if RAW
    float3 c = ms_sss_fetch_color(at);
    float depth = ms_sss_fetch_depth(at);
    int profile = fetch_profile(at);
    bool known = pick(profile >= 0 && profile < KERNELS, profile == int(CONSTANT[3].y), PYRAMID);
    bool lit = finite(c.r) && finite(c.g) && finite(c.b) && strength_of(at) > 0.0;
    if (!(known && lit && depth > 0.0 && finite(depth))) { return zero4; }
    return float4(c.rg, pack(c.b, profile), depth);
#else
    float4 c = fetch_input(at);
    return pick(zero4, c, c.a > 0.0);
#endif
}

// Neither is masked, and both have one profile.
bool same(float4 a, float4 b) { return a.a > 0.0 && profile_of(a) == profile_of(b); }

#if SLOPES && !NORMALS
// The slope along a step of one pixel, from differences of depth to the pixels before and after. A difference above
// most is an edge. Where the slopes on both sides agree, their mean. Else the smaller one: near a silhouette depth
// falls as the root of the distance to it, a difference of one pixel underestimates the slope, and the ratio of the last
// two differences tells by how much, if it is more than rounding.
float slope_along(int2 p, int2 step, float4 own, float scale, float most) {
    float4 before = texel(p - step);
    float4 after = texel(p + step);
    float a = own.a - before.a;
    float b = after.a - own.a;
    float2 width = float2(relative(before.a), relative(after.a));
    float2 edge = most * pick(float2(1.0, 1.0), width / relative(own.a), PYRAMID); // a pyramid's is one of slopes
    bool on_a = same(before, own) && abs(a) < edge.x;
    bool on_b = same(after, own) && abs(b) < edge.y;
    a = scale * a / width.x;
    b = scale * b / width.y;
    a = pick(pick(0.0, b, on_b), a, on_a);
    b = pick(a, b, on_b);
    float slope = 0.5 * (a + b);
    if ((on_a || on_b) && !(on_a && on_b && abs(a - b) < 0.5 * (a * b + 1.0))) {
        bool back = on_a && (!on_b || abs(a) < abs(b));
        slope = pick(pick(slope, b, abs(b) < abs(a)), a, abs(a) < abs(b));
        float next = pick(after.a, before.a, back);
        float4 beyond = texel(p + step * pick(2, -2, back));
        float outer_step = (own.a - next) * relative(beyond.a);
        float inner_step = (next - beyond.a) * relative(own.a);
        float rounding = 4.7683716e-7 * own.a * relative(own.a);
        float more = min(abs(outer_step) - abs(inner_step), abs(inner_step)) - rounding;
        if (same(beyond, own) && outer_step * inner_step > 0.0 && more > 0.0) {
            more = min(more / abs(inner_step), 0.85);
            slope = slope + slope * more * (0.5 + more * (0.5 + 0.7 * more * more));
        }
    }
    return clamp(slope, -8.0, 8.0);
}
#endif

// Change of depth along x and y over the width of surface that a pixel shows. A step of depth of radius_mm is an edge.
float2 slopes_of(int2 p, float4 own, float radius_mm) {
#if NORMALS
    float3 normal = ms_sss_fetch_normal(p + origin());
    float least = max(abs(normal.x), abs(normal.y)) * 0.125;
    float facing = max(normal.z - dot(ray_of(p), normal.xy), least);
    bool valid = finite(normal.x) && finite(normal.y) && finite(normal.z);
    return SLOPE_SCALE * pick(zero2, normal.xy / facing, facing > 0.0 && valid);
#elif SLOPES
    float most = radius_mm / MM_PER_UNIT;
    float2 scale = focal() / side();
    float along_x = slope_along(p, int2(1, 0), own, scale.x, most);
    float along_y = slope_along(p, int2(0, 1), own, scale.y, most);
    return SLOPE_SCALE * float2(along_x, along_y);
#else
    return zero2;
#endif
}

// How much shorter than a mm that faces the camera a mm along an axis of the tangent plane is in the picture.
float shortened(float2 axis, float slope, float2 ray) {
    float2 across = axis + slope * ray;
    return 1.0 / sqrt(dot(across, across) + slope * slope);
}

// ---- kernels ---------------------------------------------------------------------------------------------------------

int kernel_of(float4 own) { return HEAD + STRIDE * profile_of(own); }

// Pixels a mm along x and y; a kernel wider than the picture is reduced to it.
float2 pixels_at(float depth, int at) {
    float2 pixels = PIXELS_PER_MM / relative(depth);
    float widest = max(PICTURE_SIZE.x, PICTURE_SIZE.y);
    return pixels * min(widest / (RADIUS_MM(at) * pixels.x), 1.0);
}

float radius_of(float2 pixels, int at) { return RADIUS_MM(at) * max(pixels.x, pixels.y); }

// How much more light enters below the tangent plane, at this sine of the elevation; not below 0.
float3 lift_of(float sine, float least, float3 elevation) {
    float3 lift = 1.0 + elevation * clamp(sine, least, 1.0);
    return lift * lift * lift * lift;
}

// A mean; where there is no weight, the pixel's own light.
float3 mean_of(float3 sum, float3 weight, float3 own) {
    return (sum + 1e-30 * own) / (weight + 1e-30);
}

// One of 64 angles a pixel, of a linear congruence in which neighbors differ widely; range: of all of them.
float angle_of(int2 p, float range) {
    float turn = float(((uint(p.x) * 49472u + uint(p.y) * 37345u) & 65535u) >> 10u) + 0.5;
    return ROTATION + JITTER * turn * (range / 64.0);
}

// Rounding of a difference of depths to a tangent plane, so many pixels away.
float rounding_of(float depth, float2 away) { return 2.3841858e-7 * depth * (2.0 + abs(away.x) + abs(away.y)); }

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
    int at = kernel_of(own);
    float4 f = float4(nearness(a, own, at), nearness(b, own, at), nearness(c, own, at), nearness(d, own, at));
    if (!(own.a > 0.0)) { return own; }
    float4 mean = (f.x * a + f.y * b + f.z * c + f.w * d) / (f.x + f.y + f.z + f.w);
    return float4(mean.rg, pack(mean.b, profile_of(own)), mean.a);
}
#endif

#if UP
// The weight of a pixel's own light in its result: DELTA, and of each term the product of what the taps along x and
// along y take from the pixel itself by linear interpolation. pixels: of a mm.
float3 self_weight(float2 pixels, int at) {
    float3 share = DELTA(at);
    for (int t = 0; t < MS_SSS_TERMS; t++) {
        int block = at + t * KERNELS * STRIDE;
        float3 across = zero3;
        float3 down = zero3;
        for (int k = 0; k < MS_SSS_TAPS; k++) {
            float4 tap = TAP(block, (k + 1) / 2);
            float2 left = max(1.0 - pixels * abs(tap.w), zero2);
            across = across + tap.rgb * left.x;
            down = down + tap.rgb * left.y;
        }
        share = share + SCALE(block) * across * down;
    }
    return clamp(share, zero3, 0.999 * one3);
}

// out = s own + (1 - s) rest, s the self weight at full resolution. The rest is that of the four larger pixels around,
// each solved from after = s' before + (1 - s') rest with its own s', interpolated (3/4, 1/4) where depths are near.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = texel(p);
    float3 light = ms_sss_fetch_color(pixel);
    if (!(own.a > 0.0)) { return float4(light, 1.0); }
    int at = kernel_of(own);
    float2 ray = ray_of(p);
    float2 slopes = slopes_of(p, own, RADIUS_MM(at));
    float2 tilt = float2(shortened(float2(1.0, 0.0), slopes.x, ray), shortened(float2(0.0, 1.0), slopes.y, ray));
    float3 share = self_weight(tilt * pixels_at(own.a, at), at);
    float3 rest = zero3;
    float weight = 0.0;
    for (int i = 0; i < 4; i++) {
        int2 q = (p + 1) / 2 - 1 + int2(i % 2, i / 2);
        if (!inside(q * 2)) { continue; }
        float4 there = fetch_half(q);
        float f = nearness(there, own, at) * pick(0.25, 0.75, q.x == p.x / 2) * pick(0.25, 0.75, q.y == p.y / 2);
        if (!(f > 0.0)) { continue; }
        float3 after = fetch_sum(q).rgb;
        float3 least = min(min(there.rgb, after), zero3);
        float3 other = 1.0 - self_weight(tilt * pixels_at(there.a, at), at);
        rest = rest + f * max(there.rgb + (after - there.rgb) / other, least);
        weight = weight + f;
    }
    bool wide = radius_of(pixels_at(own.a, at), at) > 0.5;
    if (wide && weight > 1e-6) {
        light = light + GAIN * strength_of(pixel) * (1.0 - share) * (rest / weight - light);
    }
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

// One pass: taps on the tangent plane along one axis of the picture. A tap at the distance s on the surface reads two
// texels, which count
//     f = share of linear interpolation * (1 - dz^2) / (1 + (1 - flat) h^2 / s^2)
// with h the height of the texel over the tangent plane in mm, dz the same in units in which weights vanish at 1. Light
// that enters below the plane, at an elevation theta, reaches the pixel by a factor (1 + K / 4 sin theta)^4; where the
// surface bends away from the plane there is more of it, by a factor 1 + (1 - flat) (dh/ds)^2 / 2. Near taps would see a
// mesh's triangles: they follow the sine of the next ones outwards, in proportion to s. The sum is divided by
// the larger of its weights and its factors' weights times the root of the reflectance: no mean exceeds 1 / reflectance
// after two passes. Where weights have both signs, what is missing is replaced by the pixel's own light instead, for a
// sum of weights near 0 is no divisor.
float4 filter_pixel(int2 pixel) {
    int2 p = pixel - origin();
    float4 own = texel(p);
    if (!(own.a > 0.0)) {
#if SECOND
        return float4(unfiltered(p), 1.0);
#else
        return own;
#endif
    }
    int at = kernel_of(own);

    // The effect fades from kernels of a pixel to those of half a pixel.
    float2 pixels = pixels_at(own.a, at) / side();
    float radius = radius_of(pixels, at);
    bool wide = radius > 0.5;
    float2 axis = pick(float2(1.0, 0.0), float2(0.0, 1.0), SECOND);
#if MS_SSS_ROTATED
    float angle = angle_of(p, 1.57079632679);
    axis = axis.x * float2(cos(angle), sin(angle)) + axis.y * float2(-sin(angle), cos(angle));
#endif
    float2 plane = zero2; // the tangent plane's depth a column and a row; perspective: times that of the texel there
#if SLOPES
    float2 ray = ray_of(p);
    float2 slopes = slopes_of(p, own, RADIUS_MM(at));
    pixels = pixels * shortened(axis, dot(axis, slopes), ray);
    plane = slopes * side() / focal();
    float mm = MM_PER_UNIT / DEPTH_SCALE(at); // of a unit of dz
    float facing = mm / area_of(slopes, ray);
    float3 elevation = ELEVATION(at);
    float least_sine = LEAST_SINE(at);
#endif
    float radius_mm = RADIUS_MM(at);
    axis = axis * pixels;

    float3 result = own.rgb * TAP(at, 0).rgb;
    float3 weight = TAP(at, 0).rgb;
    float3 lifted = weight; // the weight with the factors of elevation
    for (int way = pick(2, 0, wide); way < 2; way++) {
        // Each tap is added once the next one inwards is known.
        float4 outer = zero4; // its light and weight
        float outer_sine = 0.0; // times the weight
        float outer_lower = 0.0; // mm below the plane
        for (int k = MS_SSS_TAPS / 2; k >= 0; k--) {
            float offset = abs(TAP(at, k).w);
            float2 along = axis * pick(offset, -offset, way == 1);
            float2 whole = floor(along);
            float4 sum = zero4;
            float below = 0.0;
#if SLOPES
            float elongation = min(SLOPE_SCALE * mm * mm / max(offset * offset, 1e-30), 1e6);
#endif
            for (int i = pick(2 + 2 * MS_SSS_ROTATED, 0, k > 0); i < 2 + 2 * MS_SSS_ROTATED; i++) {
                int2 corner = pick(pick(int2(i, 0), int2(0, i), SECOND), int2(i % 2, i / 2), MS_SSS_ROTATED > 0);
                float2 away = abs(1.0 - float2(corner) - (along - whole));
                float share = away.x * away.y;
                if (!(share > 0.0)) { continue; }
                int2 beside = int2(whole) + corner;
                float4 there = texel(p + beside);
                float dz = there.a - own.a - dot(plane, float2(beside)) * relative(there.a);
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
            float3 lift = one3;
#if SLOPES
            // The sine of the elevation, without what may be rounding of depths; near by, within some
            // 0.17 radii, that of the tap before, as far as it was found.
            float rounding = rounding_of(own.a, along) * DEPTH_SCALE(at);
            below = facing * (below - clamp(below, -rounding, rounding));
            float sine = below / max(offset, 1e-20);
            float gap = abs(tap.w) - offset;
            if (gap > 0.0) {
                float s_2 = offset * offset / (0.0289 * radius_mm * radius_mm);
                float follow = outer.a * outer.a * outer.a * outer.a / (1.0 + s_2 * s_2);
                sine = sine + follow * (outer_sine * sum.a * offset / abs(tap.w) - sine);
            }
            // The area of the tap before: by the slope from this one to it.
            float lower = below / (sum.a + 0.001);
            float bend = 0.0;
            if (gap > 1e-20 && MIXED(at) < 0.5) { bend = (outer_lower - lower) / gap; }
            outer = outer * min(0.5 * SLOPE_SCALE * bend * bend + 1.0, 3.0);
            lift = lift_of(outer_sine, least_sine, elevation);
            outer_sine = sine;
            outer_lower = lower;
#endif
            weight = weight + tap.rgb * outer.a;
            lifted = lifted + lift * tap.rgb * outer.a;
            result = result + lift * tap.rgb * outer.rgb;
            outer = sum;
        }
    }

    int mixed = int(MIXED(at));
    float3 mean = TOTAL(at) * mean_of(result, max(weight, lifted * ROOT(at)), own.rgb);
    float3 filled = result + own.rgb * (TOTAL(at) - weight);
    result.r = pick(mean.r, filled.r, (mixed & 1) != 0);
    result.g = pick(mean.g, filled.g, (mixed & 2) != 0);
    result.b = pick(mean.b, filled.b, (mixed & 4) != 0);
#if SECOND
    float full = pick(GAIN * strength_of(pixel) * min(2.0 * radius - 1.0, 1.0), 1.0, HALVED);
    float strength = pick(0.0, full, wide);
    float3 kept = strength * DELTA(at) + (1.0 - strength);
    result = strength * SCALE(at) * result;
    if (dot(abs(kept), one3) > 0.0) { result = result + kept * unfiltered(p); }
    return float4(result, 1.0);
#else
    return float4(result.rg, pack(result.b, profile_of(own)), own.a);
#endif
}
#endif

#else
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
const BINARY = 'H4sIAAAAAAACA+X9B3gU1Rc4DN+Z2ZrdTTYNAgkwuyCEHkRpRiaLVBWxgB0BIZQNNYSmgURApEooKmBhs7FgBSsowQ0gijSpiooasVAlEUGxYL5zzr0zOxvQn+//fb/3+Z7nQ2Fn5t65c++55552zzmXDZk4RmKMSWvlFoPloiKpaLBSVFTEBlvg3yKpcDBj9ACeW4uKzBeiCsO32GAJCxxF4g9cW8SvrUjUtkfLpCJstJDeLeQNFhqfhm9aiqhQKSwshDuZnmE7hXo7hTFtiy4V0quF9DGbUYfxZgtFlwr1bhZi40WD5enTpemDZfqQRF8rpI4UUmvYvUIcWyE8mTEDr2fgS1io5E9QFIvVYmN2m8PJLHEut93u8VjjmSdeSvAmOBISk5LjHSnxFsmeKtlczOKuUzc+WUqT69WX5fQkqa4lIyOjQcOGjVyyJDmd8fFO1edTLBa/z9q4id9/xRVNm/qbwX++pn6/L7NZc38Tv8UqjZesVqsiMbfNAf0K7J3VymW/1WEbkztmXP40mbkGjRo7qmDUkNGjHshlkn3spDH35+ZPZDnOoePGTiwYMrZgIgvYx+ROnDhkRC7r5hgzpCA3H2qz66z5o8aOmMh6WIaPGj2a9XTGSSwguSwdOnfpHTfvojIBmnYwbzH8Ya48SS5qTJcBb55facIvmc8i56hSoCioMvgnP1BcbOnjYaqCFx1kh6qoUgfZAj+sgwyN+yyqHJACLPDuQnhdVbyzsJn6LnjBG+RtqhbXM26LE6AtzbDpn6xgeT4rfIn1gMatUDfQKOizqUyVsXWGH4HnKnzSDR1xBH12qNUpGLAGfQ5+ZQ/6nNDdOCVHvux/qtKaMb8lcEVP+IKlh8cClV3wV4a/breEPZSCPg9Wk/xy4HvWyyPBF62ZshtuLUH8sgeawBFmyvAOVIGXJZ9L9fgUF3SCdWGJ2McuzAvtYbPRhzI8BMj8wnp6ZKyPH3dBp+TAH6ynGDLB7hh81ya+C2MKTJ0AX3fg17F2S4X54zf5E7oV8z8Xatgs0/Wt1NKhJxCiP9AEJHQrGpAe2PsEv67hf+yzbk73y5kMpsyLfYPRwcC6sBS3DbvthS/he9RYa+g4DNLrCsBY1PhVarwa352JP0PT/dGbYX453ZcoSotmtwkM9yhui6s2DAkkbTkMZdXmsyg5qgVQyw+jh67EjfV7A3Gj8wJZ+V0YTH/AeYMvSfVC1SQPrA+XC5AhLggQwWaY235J+9SwBT4M7SbilCYaHW6SU+Y3d4/RFJhGgMgX3709/KkZdSFnKNxSI0WxjYT9Ma9I5lewzYAtIKkAi2Q+Vo2wT3+lUgsZr1cHhpq+PnwCff5ln8yxR3apDjU5CKN3+jzQDw8CyaMDKcUEpCQ/AhAqErRS1RSAVir0RM7BxaAmB+SbPLg2k9zQZjJWTVYtiMoyQZ7wLguwEAsBYEkuGDODv5ZgwNUn3Z8aaDRJTZ0AE5TU25ei5ASyfLKMk8Z6Q4dTAhJ13KMSFmG3EZlV+F/GznmxyRSoDT8ygcKipvaCF2BGbxKYr6YEA214ZTnow9UDY/C6sAp8EXpHXZaxo/AE34XLZDW1Nw0SmkxVE7FJLwxRMr4PKPED40gkBQOtAy1xWL3Tje8kwYuJ8KzRJL8MnZ0I9Z3X6z1KCgayeE2FIMKnUp8KAnh0MhLFZPi9Bs6mqIkA3hToINQXLapUnEQw5hPg5XCxqF5EHOPL2GuXoAmIoi5OFWnhuFW30eP/ywuIEN4dKMJhxgXOSDfAr76eWmP1OOxOHBBDnwerYif93h6m2qK/cT4ZPmtX5WBAC2iqF+BUI03wxwVqWM90qKz2Sdch74szmpH012VorQ90K07vFmA3FChuvJRce20WS5E0XSo0+EMli/IkCXkSTTuDte63Bv6eHgzUTO9DMJImeIiWPyRz7mTl3In4B/QGWFnlMjNnAnzhDVn8tsC0YGDaDcTdbB3kNHgNflL4216dt0ELr/MWYHqijaishbymr9++0eegrtmvwzV9H4LOsekfyPUtvMeTAzUAO869AgstPsQYBLhcgPPSAoZo3+j/l0Zk8bGBHlyWcTilLWQH/75HIUYUOLiLAW9z+eKxbR/yPitnlLAa4/EbG/+tkxbV87/rBJ7azf611q00MzgjN8JPXAe5N/y4O8jdOYRzTBBes4hDuIIZILa54BMWRB4AWRBmXemFFMsTcCPXjg8shN94wG0oc6s2KnNhmUuNU529EGUFLmIJC5RDZ33MBAeAGVtwHWtS0GcQThoLpAWjT4ye38l/+vMu32zq8jOP8y7vjXbZgh+y8M/EdNutuLA9R2clkzekmhoqFmNXzdhFlTtxsF3F38kyvfOl+HhW0CRwVbKoxPWb3YnrSS6Sp0tFCgjJlkJ5OrzYBAfps6pSSyUN5C0J1gGIVhLyUIcqI0r7nKrUQlYBcjCMwJrm3kPYpA8QFDgv/L0vHV53qPbrfS6TsGVBGCqZckYPBB00tKGvP24jb3EjTFAcR890n8f9P8pVpYXcxI/3xdpAaMzgl754AECC23hSralxG0vhKfMlAPHcCMTVuREYN/RNdaXDqNzYlOq3bgReFd/92fHXxn1WVqGFu29o+PCpWza8r4XCqpV/1u9I774hZ+bRj1Y4gNsnqUmqe1g6/JsATF0MMAEXNlI0BpJw8V9KB/lwJrJX8y1SBXgLv5byWq9vH0g5C1+ji9c+g6/5k8ve6QT1gN2q3jBQQ/t6GC5Tk+HpwUwUelsqXr9XhWr+lE7y3szLQJZdN2j8vCzqNc6aI53XdBnShppU5sMuJJYBKHjnHuwgL2/Or5+Fjl7AT8W/40/tJJ/Dy2QQ8ZLDYejECqgFUEsu8yfDE3hQnQnAVYg8KcBvAn9lAhfCS3vgIF/8OE1dl6upy/3WTnQH8xSH5DDwCq/gd0YJo5Mm1bsXEWoJch1LYG7zoBoHb8IrVlySy5svx0qRgbQm6VK1PtYJniOGW4J+JeCmtc6H7weqX5Gp2hCeyfzrqFXI8HYUSwCePiu+AV38PhPADWQXhqXzFT48oL5+GtgRGKOEY1QCmTgA6ByM5ngmlNEihUdqHB8ufsmD/6ZExwh6ipoCHWYuaF9B/jfBZyd6YAfkkYF429REkCIVkBdsQBcurYUs0aambAz7bNjpRJiH7ThPNrj4AC+Suoe2nPr7ht5vdTZdDkuH4l2Zru9sVljw02VUt6YLZlot5fllQRpkhLLbrwAoJH6T1kk+Li7VTvJpibgJ9IRxSiEHLrAgp+olpU9sZh0VZKzVpmcB/miFdGm1EumSahv0R8AjNP5oHTwSLxxnQfywd2Nnup0roR6aQmyGP1mDTzLlzPX89tu5MKgOpFgdXE6Xg1XZ3P6dcAtt3wwVKniFYhhs4Ev+Xgivjy2i6woBhCbwpd7w+PClHd0b7eh23o+MDdAPmEMbrVVOTu5VFf4bVC3iAvBK6kkysB0IOdBhVJmfW0oTEiXiXDbhjdyDsgIIF9gji89pPP/fEgZfcINpwf07b5aRyWCnnDBkB45C9OzHudSzmG5Z9G4Z19QVvLzquoG8OQu0o5raeekJPsIY1ga6NojnwCZtgPCMNBbFGLJC8pR48O9jjQ4hDScucAQ/FgROxoU3vQ8nF/I+RIU3mSTAgAMnxKYSlYI1yDk3dBB7CHJIAJikdyHxPhs+qpZ07mpzlcgW4K4gscqFSDu4yUJGkZNhB/+CD1UAyqhIpWAx+QW8/FaUUelZmt+2MUqhbIL7+e2dFS/HJKJ/qrIeCIplY/fOT98a7vnNEmAnOp0Pe6uxM36H6giFywAGfJYkXNy2KPREE7aNeh3+eQafR7jBpcVvMVe3qDagXk2wnvwGFmjLsZZ3aScZaE+gVVBVjMd8YS5FYlejWCUkOtOR7CBbR9KBAsRfjAsQfhsysUy/HXV2EjwqMv0MIWfDVREInWGjg6TSCy7i0HkfvZjht/ToIIRcWBQg1BEvIWFhmc9B/N8JVR2dZBWbb4GkErvhty7vBDI9mljg4fZMuKNhH8+EDtquu+tzwF7ipiwdH1/IhOEU0IRA69bHkM5n8AaPZHaSW6k2WK6oVBi8wSYWJjTQSb6KW55I7IhC1boxKl2oTuDuVl8cTEV0BH7rsusc116jLY+ihHVj6eVEFtUZrt3WUuSkNuSiyAihv01UB2fLPlAhfRLwN+g/8rNOQbT+4DULfHBEwhEsxyEogQ9YkPeGBfbyAr/jMf7EwSWx9OgdYiq+JiE/ljg/dh1UZLnIVYh2DKgyOAD/hNCQyK73K+nX9f52VQ486Q6wSUeyCQwofaPPYgw3AK3lrfdbVWvI+x2iS6kogsH7bFGoSIGiiZerBuvBZ49Kio7opTN6GRe9RJXLEW1WDtgnrBe38RUh/EAYHiqTaz8MgahqKSs1GvLuJ9ym+tZoe0p62G8NoaUS1p4bX7KV+j1hf7waF/KhHO1eDZMXAoyNVz1h1RXyuUh19iPl0cUbNNaBPAFsfTyqh6oLpceRcOlU4/BymGqScRz4ZDDWi0IE3kFZ2FYaLsXS0SopigXG6sXvvQEroPiq5UvhoRpYjuUZaMwqeGM5UIGprtGSXIQ4RASTeRfgaD0ssErySTiNXuiwcgPZmiTiwajsYIED8AL1FOn6dB/SHFS3UXOR8YkqjSZNPiCPCdiCo5HuSmgFOG6VFF3/3ysbIgvX1ugjiqDpBx4jW7VZG4fOQDHwZRBM5v/wyO87P1r060eCVwM1N8kXtZl6ZbQUxI1uJ1fO3L1s5yfLPxTPik3PevJHnUhGaSUkksNcZFHF7QV+20TczuGCRlZUKnm0AlrO5GKJiuL0BuJggW3zqSaajc9yiQSFlh386Xi4fJ9flkhcDKo9jlCMcGKUVuhAMAlZlymujBbPlY3iFXpxsWwUr5BogJligBu4IJQmBLLDJLFlIB8WTy7wChZx+zWXwtbhKHbw6714XcYBVY3XK/h1Cdq3QtEvr4l2bKHese3Gs9kbjKHKQVoFubt3bzYtSkBVvyWd92KFTJ1yiE5t4Ld6lx/l318nk9wQiNMlAb+CEo8H9XuFG6MYGqBIqu5AFBGx8+nFZukJ0RZX915Zlx8U1zsSEEulUOC6esn2CzdEo0mipUIaDRdY8A74KIM+4ZV9OGeP1lwPXwGopSvwkmrFYaC9SrXTlWoD+e7SPZsti2MsY6TNqiAE0f6PXyJNBFUew6rwSpziKPJMl2aInhe3yPM79FWKxI5TCL/TI3Qj+JgTmDt+7Nzy2msW2L53jl4fegfKj3em6X1bzPvHL3nfEdjbnPRR1eJ9hHpoRTrjBDrjJMoTZ5gnrEirXAHaynKgyYajlAPJBRam0MQ7AufmC3XCgRWy4Mk3fCmqQEql9Wi/cahxAB247ASdA26AFguUz0mQdQZkNLV6Agqaut2+eAQqmjqB1kFFp7hyBtyG7UrwT2g3nrd7J+8xkBCuPKAAActN2Peol8111Vu7B6Y+YCEgWQBIj8+PARJovTC4LI9kguPyWNqJNquY8tmx5QrCWYVew+QsFJMjqy4k+7RrEa8ynwdNjmgmV91Qa7ZeC0bhwTXixE4wf8KN2Hk1AWVgh+pE0c+B5kBjkgEgv5JK5DB93COmGZHrUeP7HmAavOl4YIfxMNfASAOVaOPz6DbBuD7cJogMivY0afsiXpWux+UC4EZbr0O39erDX7WcehBr6wVNRbV65xPOWwqERYzrWT4v/XDpSMINMUdLpbL5O/6k6xw/ZDdUk3CDKsNvT1cR/fy2dF8SHxE3xWHt41A7ebkvRbVyuvmGL1W1vOGrA5K2r66o3Iq0lDTVkSkfbv6Grx6CNO0NX33VATJrc186mlx0mVgmmdjrQrRRfRmqtbncxNcA4FSnE8DcqYLwBvBXQe93w0/9TsBynCDKq6ko1DmRfiTzq4ygmkJXahKK1U7oslqPF2UGVS8vatARmJszkB0MEAl0IndM5EV1ed1WQrbMWMZtJjYPrVRUg48ckUajuUU2ZtnpXUzb0/AesG3SEe0EOtz3MNYyCRpQ5ER7C4obCqCPQsJF3Oh+HgU1BwXK4sb6FL67hjXj+gHqkL2lh0fmeC2+i3abuPGIQKODgFRAHr0PE0VxoiUW69kIibnIotpBaCkIekuoih3tzHbayXAARdSppdO1R1YspCNGt9ktolBsZAApoAEisQSBwu+I6gxooOV7DBvDpP6juYt0etWxsczndJHR1k+2W4tfgv7D4Nf746Ac5MNh6X6nSRB0IhK601FDCkgFuLsmc82AAEragT3gRsplDxwnNRo3q+yI+nYYrM/uInHRh7xZhpehQfv6YbC8aHYkbtuwqLQFY6EtGGrYuVLvQ2Aodf0ln4SzgTCYijKfhfZpAmiCVoh+zXqUGI1h1LZEvQjsrh1W2VYk60atigssz2/TWSq3Yyvcjm0Bgg40VkIGQGTZwcmynZPlOJ8LybJdEGM7FPMrB5BlF+0b+ON0smwLzEWJDoQ+70HOz/ELNkT2dVPhd10LQPzA4d1Cza2v2ro9BBfejsqaFmhdIC1x7xRAZ1dvEP2doMDQVpotsKYFYB8CfqElqBuRsY8HdzHTvQOVLIcwetpQGkV2Ti/zrhmoahPFLFowlwqA06LXhA3W1jyB1HFBRDqcewAcSREt5KncLcKG13ub05PlfjdqAQhQL24IIA3yAJk6DRBx4+K2ksEOqo6kO9XWXBncEfQQvJK7dwQJlp516ojrFimDh791FSz6N+AS3SLg9gion1EV0QlKYzqvh7K1LbCL6cq2lRi2DUmD8QSwsQDayoJLqIhzjX97p7/Bi7OxfmagCcyrtWe6/hoLTA3CcrCiIRNgYw+kgU4SxA1Yq5KDWI0KIgDKqrrSVTvgQ3OZdaTpcAShJQe3M3FGQe+DmOonKwZNlBN3opxAtwCVXGLnyoYoK7DZ9YmioLXEUoSaXoBxDcmCa9iPJtcSNLQHnsoMepdw/OakACm2gmQZqMXeTBwHXBzO9NngaTa+EcrEjsEaxwX/FDXyLH8kFwTf4Lp+KyRmtuUcOm4aNqIc2Z8dMGwFsdKJJBmXQYlu6BCbhxJycSeJlqrDgCZc6tuBPhtiEdYghsCZpA2fIBXlHCELYfiXYUIhUg9P5jbXn8RgvULzKuPmAGcgRD0dgaLeJA3BwpVgJAv5UGAx0c6qzLfm/Bb0EELahBSb/HBwjKAZB5GSXv57aPuK7sYSm+TzGYezHYcmlF64XUYuDqoD6YSrRLYCsS/kJjCYUlN3xO4r7iTiLoMNEQVBY7JX6INy0qBMBYEiGByNAaQTGQXznunr1Tg00LiAMaCTkItvBtPmQ4D2vUkVAA7hVh1ohIjDzsdxhR9FY3lMb+4ZIJuMIJHQyu4/j/xu7tsXvu+KxJpYtg8NETZjaoWVFqWnd3xoJ4Uy1YXwu8xOravYKjuL7CbmZ79En7cgP0Ij4aX6fEBXqBDaAaJ6FrixpPuBknmXkSRooSG7g2g9QkLjXa4/5gwfeB5tRgnRj1iYTY3LxO0NjhSgRqHgb0FUIbXIgTNqQ/XHRuQfNSEfMnalACAJLfT2uaFxD7EVNzITaA3lfcAWFZtQ4AZQB2cA+CqRehhlre/YAPOgGP1c/LLw0oDp7S3a84NQG/QloHFINIxqoJf2h1yESgmqBY1FQLxQEUxUvaVQGR7Z8AP4KElNCvuTYSQhybgPmSQCm1EpRU02FfhTS8v8dchVhvgCWiNuxhZK1VTkdkVGa2qK8VokHCrzJeEg6kBBrHsVWUu86LwDDXtXYQ01KRTG31CZ6vXuwynjZjSAkMsAUaLPC+gE8LHSPDhxZpykSvk9gqDGeR/jwhRukpPujEzd5HZYbpUVWJMmlxIzCnL1FGn3YdKaDuC/JMykI+pxzHz1MZI9zDshAjSEYhakJriMYL5p88/JtQmHeH3h41xC9Jp9BJDYQA1UBmHB01hwRajSTdQELOEm8MO4l4De0l+LeUvRrRTaO0RnSKm3B61vCl4gwIGzObB3QrxDluUnT8K4f9s2ilpHhxp3ubt3B4YhvceN7zjUVVhp98c+bXrc1SYRqQTJh3G4XUYjz9H7C2Pb8yjvr8mjA7RR2YdmCD7yXgLxYRZuInA63OS8ggZrWM6j0VstdiCZ5NMDK4IG0/3kwlDnu7o27zns0t7/654RdflO3uX+HOA3Gz2XAieW8J7vjen5ZSaNJEFBVZnw8jDN2NFLiJodReMsUfylmFCTC4fd5MLhcP0pSRaTh65VNxER3wFV02/jMhxKcfAkXpYl6FMRyLO2wJs/7qqHCrqKBAHld74vEShCSQUYEAgAqr0PNOF9nEim3UPSGy4jnCJLAPSDwNl5ZFOJDoAGDLwLKC3f07HjKyU2VBKwWRT/7dyDl6CKvFrhm+IKyU/LoWrgKWAaiiFBIYex0681unQdrs2SVSZ2KhdKRbrDlsQxnOzLiNDEzoFqE0mUydfMj/RjtDCU2cK4Z68q4dLuaa279//T58wJ+1AttJca0o4VxRzGjbjcwob8H4gWXJnopT1MtjF4GAqHuK3IgRJDGlEiKxEtACDqliAckETQU6KeAwchXTXBpbs7c2u4uOI8TkpX5UQaO9QTT7w7SVL80AJsVP4nIsYEEfsHPhqoJNJ2SpA2uaffgVog5644OzrRMrdyCc0L/IZGsMBHtCvsILuaSrwXCa/30jdjjCe0LzAuGBjfx8PFfYVbzQD2bnjRwx144C6emBxf6cTVDEpDds5EgyLlEmOK+tFGb6mUljhOiOrFibKTyhDHdSuUMxPpKQ66E3oK4Yq0o1XqKoMGJKguAlZ6oGxJrUXK6bcDSUE8/sSrCYh1CYIluQNpQRieB388QvxXZX1HB3A0KqU4PBLfBfGibCODAuJ3CBWTPy9RgoBMDpPaSTQk4OX8QY7lD8+U1OIPtclJP0kuEhhIRHeFLciZFvPuxioJKHQ9RQ/9kkDO5eiRD78lNr57k65KiQ8RlrpcvQV6U3tm1Eb4S9E2yToTRXZVNKQYDb2pWKClQmuRUqg3wxcHQgC3fFahYhTG/WSSqoR2hpvGSoEfdRUy5nJCaKyvOGKLph0/wDtc745A8XQSp9yEZT5PlIT2Iq9mK3rcqu5QuMz7LfYwjHdhQUDq5YTLaLsOp8IT6xXugdlyi5fwUpQ6cvSWQOpxi3Y654RhSGUoRIOWSIKPA3GGG5f9ccBMZHJ9l7xPErbEcRE2jgZ3E5mBELJQHcmdH/UZoEZEtQDGUliNwyWEPacqQf3OLLOFybKFJM3vxjXhjvJQstYQWF1Eq5FqBshKxGV7VwHwJk6WgRRziCs65VUlWqEKUTyFc/eiBBFwYQEOxUgZAnI9WWXcjdlietdvTfcjGQXWk+4Hcgf1rqcF5NqooG8TYYpU9D9wBYGAASWIMjqtl0mO9zsBXlGUsRso46qFMm407CtojxAo41Gd+BPP3+MIY4V5h/8QXX4gszA5OFpUT5nfw5+IBvcCF/EYOFEWU3ZcC4d8HvRcddOOcCmfELTFkhUBUMJ1CUq4TCjhgEqECAmgOfidYqvI0xnHqLoMpImDrtrUBB0ZTGyR7LaxLA8qmjGnNEwqPOeA1LR5BRDGxMViDJrVACkVgx0a6xuJhiG+UXABE7QIh4K91fEBwwtwe03yPkXc0LVUsVhJKDDk+oqoq3gsTnCf2qf1jTUhIwACWEEAEghAdVR4YI8OnmsuBvdBHyzjRlV4R0wOBjJp9oBTiL52wuHw8Jj3Ax9yA4DD78Rdf4dQbMibVHXoTaoxDfQQ0rGj+12/XNjSaOxzEqlTIIGWwrONmz77/JvCL68NDxNbhWjMMKtxLqNV3OqIaRnXV0yrElm6XLjcajUufBEdQjMj8YpPJ/fVFsaspQlWSQhribrEWu0wRFbdeZ9mHneNhMsjcK3qf1D88QUxmk44bbIB7yHpfrmWhhnL+q2q3Fnxmr5xjjijtbZQgjYjnHrSUELcRSnasHA34C38taBWL7k0LRxzLX67uILx/P47AFpIcmRAp0dclCMxXCVRm55yaVsR0vbu2tI2Str87UPC08tmwGFwzrMmA3/IL5f543CL12lsdw8TBl65lg1efslnidrgUZohu4o93SSuO4S4Xvn7NFjEx6ELMRJ7QAjeAeFHwx2CvUEOUCUojB123CQi8PJnwCfiyjhFksVzl1DmBGpb0N/e4nMZFMSMcvqEATrSlJXGLkP04yBXZewOwMng1zrEtLD3S2FlMMBYrYXIUOhA76hKlT7j8Ia5xAQ0p0zQDrvQPnWa6wis2IeCnlBM7YbJrkKD9iQywfYiOXQ9EjAJRQ2HKodhBCCSeVeJZhWQgLkhip5HQWcJzHWQMYn3LE3Ilg6ULe2iJ70FT8ZtD76BHNhwgsROR2DX6x8zlE0dgcPfnmBoSgKxxxf0eeG3UsXoNhcFJQWm0hT4lTxfMod5CjxwFaA59/DP+GYqdLMOGpx8ddVUXxrc1SODBwLCX59mrZ6aNJrMVPxb6ajC8wGBppiib4skQL2U0TGPvLRpDHBW640O1CgTqJFK4jgBCnNIXx/2yQI26agVTUgHzEMNl8NNQYIOtcOqgmyJQ84AHMDHJaQWDj81BeEnqa5e3JEI97MQdGRjpa/A87rwdhoJmHZqm5ouvbRpOw9KdQkDgLAHKGoS9awurQnztBL5DXG/DIHbGMJFM1cXe1ZXTcPovzS1HjZYL/CQ3mY6AD+NgF6fSAf1U6w/O7fXQ2OXgZ8d4EcdV9NNHU8ywcQFQ62rpvM5pVlFYc28qEAKMjnQcRuAydEuzgw303vYLaFNW/hvmLu+KfSI7mVce3YMt5PIV4VgQlGx9oAc9LtxZ1F13agHsamu6/Xhw1JApKXma+MfhzZvHYlbncDcFd7RQQ5VBTENpM70IL2wDtYLyEQyTYuYBMVXj6LJCGXS8Fmamo7vpouHFOcbT5BPpI7A7JOgIsJ8LWS+UshEhThEvusweuySX45BAAsSt+KFDvqWPTB7IaGUcAuxiHAn6D4uam9gbokDV3AdLK4jaCKMn5s+KSC52hF1MRogkW+yxOUfkGB4HEqVpsreZ2JJp8L9sNGJiei0hXxxlGHp5BVN5hFOgRTXKdmqFFlI+pJModzGvrYFXUW8INtw/xpLN3J1s3BXN5xk/hwhIK7oBzoQ5b0xjpwk2+ibFG10aj76iZwyisFt375ZRUioXHIYxCuLkHrsKGjFcQ5lapn4vovLtLFSRBwM2SUQFrgMXZq8S0F1K8NtcKApGAdqVz36cnYhhFy6IYhQuLnCR69amisOAgBeEQwcJs4D7JqMdRLa7Y+4qAGLSaz61eqmMA4Ud6dzAUsq9BTJMyTTpopkeI7J5hmVzMvRasAA3eCiQr+JNZ4RPtq2cBn+G3qH+zTLSHNxK6gXBjjbA9yHs+ZiTY0daDGwWtNwnNyFFdYTrjGfKXBL7JioqF4D+OJxg8SfENi1aR+sV7v4kurp6ffStm9CYDvyL/4cIC0e7v34c9zUDsiqN111jKa+ePS+jPYnvqFvUspmEmbTxTU5ULcvmpHW0yPoUZKpEnQuKSBP9iUH1rbxeQNxvhSokArLvA781oW/QICBGqROBOqQ/KqvPlAL70S1zqvdPlv1x2n3DH96N3XuCxOBiaYGHv7qmS8fBMYJK/bdX776eRqu2frdDrz/wVLPDH/9F5CcvAB0ph48xHf89Xx11BTkBSlcyKmHVlRJTabtLzW9qwwKrVq/K3nNQx8nAPBUKd/vvVpm3dQ5KvxaZndzz30vKg2Kq3XZYe8JmtYMNSNU6qPXg/4kNbEPDz4m0yhZN0L+jKhdgF+FP8rRbRkZZWhJtYUwiCohcPDQt7gF/w5Oits0/W6xOaNaBCJT4K8TaAgG/cbpJJWJBoS3dM5VOeF3uDO5bv11veOJlwTeK/QrFTqNa8MSuneuKaqJgXwlXDJpG69Cpy/kZbvBwX/Xid+9I1XL+ii8fNbui356O/Tbh+u6+mwBB7cuBfaiZ4M9iK6TTLV1X7US//yO7ujE+0Hi3cs5dD3avrXBiBa+m+f8PfSrKUoj5LdyqTsQOklb7PWIpNl5q0KGQD0Z7XiGDGlYDKJRfXphZs7QdOPGCzchWK5WnoYg1tkdhwDNo4Qeh1uRZGSkQel7GGIfBT3dgbXoSigsfvzHZBsI0wLmUFnnQKD4kfpBox7+KjzBlsjr1IUws8L7QDD1MQKs0kSAbhrupoKuGsURMv9G0wuggh4gRsd7G3Dkg7iKbri+JJXBCmOwNiVfKsqk6w2NrTIS8tcxBo9xm3UNKOEM4wBAvILVm+Krj4vdhB0CKRiIgU4BNA+s77T1/nRT69ENJjUt3fsj6XNWNZHA4vG7uMEXIYsbzxw6NPQMJPHooksSaLoJM/RWGqCnlOroB4PPCIznHr+xpMmqNsDNNnz/8nNo9T5Lk1cHKohrgD9G6+o3daI3IX9DmB6zHRVXrYtPIqz0KGu73Nw1hIGJ+QMl0gejk4m218d599C+C75az1g6ngAB1E7yC7QGmhO1Vw+fAxVUYWbrq2k4njRKFOFSk/FZMlBFUkhSEaipuOXdE76G5nbQZ+xkH8GgVh+qM4RJGQbyODBryWh/Eu7aJ2CGExKfdb0MTUMkToE6Aq+DSpKgqyTkTJdK20yc6AvERPMbRmFDP9NAmPSS2Ofkftjdd19TNPwZXPZlwl2RQwRNbfb1fmt0ysPeI8JTyxrFLPHQJGuYoJZhVmBc5HmDhk50cKkHyFef5q+eQAP4ehEGksB79YUG4zRNaTiqghhzQvTHIjYq6CP10TWhPsyfpRcUodQMX+JBqeY5EvvgtGZjCY8N+gX6BLFnZ/p6n5UUtnocJNgda5iYuJ1vjtj7gJYCNAepCe+Vi3eJI4lKSOLkvdGXF3lTmWw1FNV22RmNiZEwmJXPhhpFEu0qQbNJ1Dc7N5DZykyUmadgocEncvk7kfKb+L1C/paRDRk+XZJkKTT8aaISV1QaGapGzctDJ6J8La3ESNuVPBeSCnOEdusQWryA45IZ3YKMOhwmY7qVdpDkoel+FJgs/C/cSaW4sRIKr/Zb6B0k9gzfMQQ0btCFt8q8n4oNCv2yFD9qCZOZFSgFo4bCoVDYdaMkxWwZfY+WoEs3jY6Lx8a2EdqNhC0sul/0nSxbokZbtVZ6j6hdmBtv0ezGhCu5hftvc5fZIu7Jg/4z5ECETrSIFlZ05uHSdfHsNoGwWAA21L6GYtQ1RZyaXUrkQCV2XITuysbo/NwhEonF4QWgCenWPDKbwRNhzKNELehqJFMJ2qhB+3hBBFmDxB+oXIVuS941XEJBv2oMzhDKAd/3iyoLqGipCukLZLrWH2Nb3he54QojGy3UhZW6UbtWgMZGRbGDiGQpUmVOyyg2lZukQNeUx2AIKkXwckAS+6ZQWXRUo30S8iOhfQ++XYJecGjBijrEbSRxq8wfDTULPeXHzYs41VW6snvr6zJOHe1QXxuazo19TqIQIL4ixaGEJB6yXSSQ5SteTTCiuy2BdVkoNCagZpwgvPE8ZAu7JOOHorvnUv/RCwwlKdXaE94XApWlh5jn0EqJLD/czxFdSjx8lDYi8DYK1YDXgK8o1EHoQrRPDt4lN3lkIfrE82a5cxZAdfuq2sFYMBCce4n7ghmJUmiTLZCFfRHuJGZ/JtcCxeoUWp6hXKsmn3Fc496XuH4PiKSr0v+kVANKkR5Fgbho6uDcCfeMuVMNxlRg/0BWtNFmapASpLnJgIE+3m5AvZdjbQUeCvlw6ZNHIgPuJ5X6vaoX+EwIQJvAbRYJtEMO2l6aMJvEgyCaQAar+KA/kYMYwx8TdbaUwE0gxovcIBuHoIojPdvn0k2eAgu4HCnmW8hEhqJBlk78rv7NBOqqmsj7XbYavxnzKYuxllynrDZUOKzw11JkNe816TqHFFjzsozO3+sqDedv2nylhe9X+FRFLULILXksvBmm4zVDC0crntCsrdz0DcuddGm7Gp00lAG4SctuGLFI2ldRKhSSAE8CxLVuwDIcIXYWIGDFFB+1rIVhmLw4khAS9KmID1R8CfXjVa/qCpNrBj0GjOD+DQ5E27leAf653tq+UZinChanYTIzoVAikhbE0DT+4w08NMMcmxv17DCr6MnRyxQU4AEVvD5MSBOH2bHcQdU9kUAEiEGjRo2B2wlp4jG4aEXWaHTymYuw45QNYaJjcMjv7ayYN55Y1MmkWnvW5HACDNfbvd76RyZufW6UJpxRPivDWO3mOWGezczb/eWX8M8XmvckTTba3np9Ww2qYfN7F285n/lKJMQTnsUH9ZYrx+WEeTIJUqUnkGYEdI9LxMjd/Ji9zxoqDakpPDVgEojtLrgvXelPBrSGv8MwAskKwrMLJGcRyWAsCAr81gUXw86kJrrWW+SEqGZdIhnMGZB5BdE/iRiFlWcK4lIu8RcHMQtcbEBo0NNaQYd+k48shva5fBQLhwSWEDhebHNQYkfEtbnCkwaIawIRVxdSSdzyWJcVNCwLhqukjQvoEqZTQ3QiBi5xqVxsfSc95U+utfOV/BKldxA7XwCDJDW5VEUbLRsN8pQ9qK8KxAjMfhS99SeDkJQcwrQ4IV8y5x/QvUS+A/SPY1STw8gq+dL5PxosiJ1c6FRtvXwit54Xnb5I3ee9kE29cPuwJ7G9eIfHO8wWn6/9dVwX+FnRi5ivY45Fn6y7fgg8UjCri6CSeyWQN5BdwQeIy6LjhUJMxUa+PnjFxQomYjN7C4d8csUgFQCwLEgMk8yyXGjArGY2nwQCA0i8ICfzPHwuvn8gc5O6xH/cwn1FoiHiR2eTF7cws5tkeBsNFXkd/uL2TBb2OMZPodqKgRlA98ViyDIYMBcTuUguB7KEXxZ5ewATyBIswHWZ3W7sCwq0Gy7Z7bZgaA3zywFQGtMN2QydqBhtC0t440BXNJDjSOBsqWSa9qnvx3pm2SPTrOSgFd/7KsnQMknNXODlG8NSVOClQdlR4D1eaTEcEcnfDJ8IgddB7ggk8OKAcM/6aO2NcRLHgR44iAfqAbgoGasO72tGT6zkE4kexVgvCknaGrZgeghrfg89hhjb7EVKDbopOAIVb8tIv0N7laAa512L72I4F6ZWQjE1qmFhnJN3HZVLtAkLpYwDdPqEdARlGmqWmTJwP+/ronNYE41N+KXqMOYoBP0V82jIfJGpcjDGU8TDBS9MlaajAMhfMdKgA97xuwJr3pZriYmuQMnbIrrdpcceKEQFFD2UQu7DPd3f4NQYLXOge70p9jgcND26MiBzH2PTQ7L51Zom3BazAOLr+aBcz1iifsZ7zTbVTFmEubvJpro9mjqhuOLSzAqdgqplQ+faSRaMOP3KSxMvzL00h0FxNAsB5VGAKTIlWYgmEXh+oZErQeQKwFwJr1+Sa6EkNtdC4JWFRjaF1xca2RTI7UhkYTAlVpir9/3ymRWKzZkVao2DciS0VFRTigRYuPyuWCQX4BkzvMGAzUgvYPVwlyTuMcw9Hh0UnW0VuQX+mF/bw/chOeBTLelcieYpCZTePJXP9XorIkumjB4WlthkBeUltZIVWF080ZXAAqtrZZIliWi8IQUXt40KCNzkHuCZwhy4kwVqM6zpQ3p7dtwW4p+16LqnsPSi1E7Zaaw0rUKXcwjc1+MDMPA1MCNIcdy6WmtHcshbQJstyihxQpk1KXxMEDyPYRjUfY1l4IDrQByk3Md27lbuJh8ta+xUWgMk9tiRiXArmJe+YqcmyJeM9D9/Ysx7OhNAvzCrMBOaSYY9pjZPy5Sg2r1viaWcFJPJWkAg3s4kSbZaFLsLw/ssSB56e2z81YBEtg2YybdplSe5KXtcQoAiBjIR/noJfzkZR22l9Ml+UqAwviglKmWngiBRR4AKBecUkq4Qsqhg1I1WTIte1qNwExYTwpaG9FOtg/YYsvtZuWJj7ZO+nixuYTUt5EvTLW42Si5J6TxNzRJ68SaQJ1qNV+uF0DrJX/Wa8Qb3/eFpHTTkQ7WwmhrCRMlYIUVN5v5ECFVg+lY11bwVHL2t1obibaKaCthJ0SsYZZxCwq+CbmqHM7iqvTeD32/PAHyvA0QXvlPQQa7Ax2T+6iBvgGt0Mv8gg6fhKM+A3mYGye1mb1MOXb8D9zhS1hvArS7y1ecRzJhjkLDUBFf+JgAmGeWmVFIHA8UrMHobtVuxY/Uu7TTQPiCAKjVqDhTlH2shNb1MVMBU0vbLLAKMloSX1TSTLVutW0ZyrVghaaatwLToelEBHIENGUHe2cDjUvcuC7OOPjqtR1eUIx1B73oifGlq/aH5lFhaQc/ChqK+4f2O2U0z8DNJAPsUsSmCKMC3KE0mW9EdI4RPTfPxhKr/sRc4FF996LaV90d2EQ2rgwoZigFQwM0/6KQKM4LOEzZYKhQ5i52ETxNZIFcCFNwBEUcHaZtM8W4QXqqCBPKhUl3M7QDfdnL4q2mqFRG882VJkINw2yFcB6gr0Jrb4kL2j2uevoguamq8LlwplCG2TZDicpsrIcQTbjWCuxX87ngbflvCbyvbXIrmGKuzHe+Vjgrh90wTfnO8VgizESfTou7OAts+10Ic1TrTxwysucqo8XG0Bn2fzxp2/HvWPfFk64dWPjHhWg5pPms8WgIABKpBZRuxZW3l88oBzKFuqnbcXA3RrHY1oKwwP5xW+Ux5wuDd6jb+tFLyEeKLTxHswEVIaYOJE5SJT2DocqjJ2RzOp0PkBmY8cYEEIgMtbJQPMFIOpJ81Dn7/FN47OsgrRCKf5fh8Fod+CT3Dide3QDrIIdyV9pDQKxUElCD6SBnxXlYS4yk/vInxCKB5kZ8Gsg0/YNWqQ9pD8SsrDW3IYfYXA5UjzW3O14sYbVPjOFtFfKgH9JpT+0tWqT0K5LRSf73O5BOUpNYzO5jLelvUmppWZlodOjTNn8fVgOIjOXugJJEQoJTmSZTeHMVstCquE8o3KcFid5EIPXrv0j4Rih1cAMc1VNxWF42SXK9LFLoixexriJwUURpuN7brfaDKCSMeskKHwPkXtTDPPhXGbEZcZVF5RiQb3z5AowfIwuhRRrYMxLuo5gRwAZHASHqXQ65F6OvhDCT34akHDLvmo0677lSBEp2h55Y4jJ5zh1d9ywX4eYxPoJOnXqLc2tDpO1GOQgUelwEzx9vYeLwNWUBWGtMbdWmwp2PmO7/LZBwRkVVxMbueGG/jpIT8NGTuDO0mYVJ1kziI0qWbRBMAK/4ESgzQuAMVZIqnH7Gp4g5s4M82mJ6pUnNl3SqpI/7D77bj3Xa8C+zl9fea2zjMnx02nhFdl4RoWxCQ8jG9s2W9H0YQ9sWjMaQXsBCJ7B9x63n6bOQmxiadCCRyoVsOWl3LeJyRE288ZWaPqgQDjCJiTkyV2LhG24mdMhvTnqaLvAd0bxNhCOSmW7SD8cgtIA8Y6j+VmFGisT9tfAqWtzjmxGzLdQH1YOtDaCZWE0tpj1G3meGD6Kp2oW2yLITO3W5YfbhzQu4FjMKfKEqFQjD0FRHyJw7lURyJFH0Qx7f/RVJ3sf3PVQiexTwJMJBscymkqCfxmSB7JTkxq8k89buaqm9ay0p0D/sy+InRbiB1oZpA0uToIA8+RkxH0o7pBmFyTR4dCaoruq8fNUPI6X5vKe3Zo5Jh1/PPmxdVIqnuLQWvQJOhKbFloitKS3ikOAXziJoUblnrDaJbLopjTBiajunG8e+w9FK/K9br0U6BK2SeAq0Qd+JdmFWUdgNCBPfLYA0qkqm9uGJH5kFxlsVcosTcP1VN4jWTib4mC8nbyIRSonuqut5QZNyxJIpoMt1YOB+2owft9Tznwzo9wodSvoEG0QPNid6NPD4OGVoCbhZV/+ahQwACFV+5+U6bVECN9fZ5onCMF9qIJ2Dt6Qft2eRzmiCiW3F7L7BOl6cFgcZU82iHsQNwHarb6BQy1CISA8ihv9uGTcuPPDP/tU/EdqCDuzWTGVXm7nduzlLQ1omu/d5yGkeCGj+UZ/Vzmwl8gi/eMM2ScgR8BBeDDHDZxP220HxH6i7uiWTKx+cm6IzagBigoACXhZsxHQFnb1o9Aen6fKMpS7Qpsk8aTSFjAIxwVVjsuJWvGE56GH9Htlc90Wdv3RVaP4vJnJDdZxUZO5nfRrt5gdiMrSonkQi3LGOrRlc8TUTQ5CXlpl2BWMUTHU88wBqjU42BuqoHFc94ktGsIcBX3SLuo9C4WMWTtjFEE+RuarzqRodH8apdzAzH+DhaB3EYTxXG8EtK88pNzDwS2AQHNCjGLkjuAIfTvJ0bxKFtYRovhYW5Gs0zTpP5lywHtV7xu6Mv+Z1Gs0jISL5zq85S3Pt0iQBwvtKIsAZ41pIEhUc4kpKSoIOAxD+PrpYIbx3TjngCjTzBUEt6iQwqSAGk2PCxx91WO1nZHdEs9SUWw9RO+r6CDF/PqyW8NHjOM91+VMjtR1a/k0LSnbS0VIlvg3LqiLlbSK1SuAsYT0UYF62gusiE64tz00FGFhEqbsXGiVmjOQ6DcDBF2PWc6/CzWihs3pwXAr+jcqGFn6zhd/P81nYuDnBPfQ+HqwRgQp+LeLG1lsB9WFEShdXjJV0CvQfQwEQOGBYg1bgwFfGI+k6+szAuL84TVCAu41DjaQE5SWFVKN2REiSh+R2e9WldFlddTOcpxJF7BSYom+sIRjFWZEGLD5DvBfS9J7zo4SenYY5yikn9p9G6xNi8fNfeGY27AvaoK4RlBk9KMzzS00CETQRmOpz+/KiFu+/ehX/+0kKgFOj190Z0I4YC9ZPh+elbMFH26/AcE2ePv/Yo1E8BbYacAOPNkQCpdC4SFxFgdIgOYvWQy7fDbAfzok8DQtQk3UbNhjRtdc2CL1pr7QR3qxonIt/kkCrsgGG1rsj4LFQXjl98rUBXLiF5/rpqXdCZRNBxrDAuxyhcMq0bD37asJMp0VgbsSHmjLGToSLqhk+SUz45yKh1CUt0vxudnqWqGA8jh8NqnTK0pcUiiI03AIozOrsImPoVY19PIB4eCsIPE1FEElsZSy5rTKxLpvAKHpMSK7eYKgFONXzheO82NRjZYlwOTTe5Aw+LOQ2kTim8VFets1o8+h6Ur7rc5CBCSr4D/OGp10GoC8Fklfnq4mxt360DBy33sXQ7yZRM/HKXQ0H2ktVE7g0Qxv18TKAUQiXVSmcTqWnv+OvxpgHShjEEY3Dh9gG24K8/fCe0MpNAHe1Aui8Vm8EjWdR6ME2pZe9QejcvLXQv2bq5W42EniBCCOOpHe4kVMvkIg76GBBN2dBXj3GPohvoGrTDhM53fqtq4c5DfoUTJZOJ+wJAFNG6MHhJEaYdwA0oGyYlxA+t6Qt0vMSiS4PrJJIGkWzp2xnm3QKrYchHlzU0dmACAXtgri8oAvwV7pmLGWdUKw8LK/ZxP3euZpDkA2qPaqFEQ05ST1FFC6lxIaqkK6OmJMggfgYpc5GlF6VYxm1BvgvvetNtjyMfIVkPVMjR9x38tihrxXMaRoO8ainwxwkbjIuLrAEuvQimZhfj80THRy7OwufKUPGjeOBOR195HonmS8TsCkCskoAF4AF66CqD5mGkd7UjY+rgZKLvlZpC6kwd9Ijw1laEWA6X/OuqrE96eDUgZ51S4v9JATJXJ+OP4atd14c6RV1CMBC1RBIzctsDzoj6T4DvzBguxE6jS15G9iOK/oMWkYlT6E2SqRzdLFA0pCEBAtcNGuOJQgQ6NS7dNJFpaurK7k+2LJ3z5GzbtWGea8yHW794Mp+fKyoBvnkhZoG+XZ/CR2k6/IlBXzrlhXRDDzLUdF+DgMPXEDsHfxtBjxr5VRxZI2hDVe2onmWo9SmcFu5h5j2qSjGHPp/aAIDSEMhxI+RIpKchiHStOXWlmmYmWBGzCh0PTanxel3VJ/KypYbK/Kkm9yQYLz4NR03yq001oKVahVAG04+TwfOaJetgVt0YL5SqJmHPvJi0jeFeNt6GKSY2CR7Bc16DGztBYUegJ2NGEphFSjUIWJmsZgC2JFC7tZo0WmN6a8xoTWCZmEk7HVjpTxb4BQCuS1o1KP7QbAoSg9i269Kjf+0ubxlPyfQne+jUpiRsO5HsgHxPPh7FHkbkE/Ndc9tDBlbJUBvgTwM9OLsh/jREFBAxDhk3gKQnvOj18xiFkcjF5VTMhgQMEeQdiUxpCjc1WLlFLYVnuWFc00CnYeBeiKXoFwNv4B6mM3oELvdP4V5AdhHmBpfJIsIzCY/7QnOcSqGjRF04Lq0EJoKTVheXnsO0MkRN7ERSkIw7/mRywFSTEG5yj5gj2lJxAVNybTU5CF0zOfChEQZnKckcMmE6pCtd7NGJGXeYppqbRghD0R+kzsrV/jqYSdCM89R+kppC30jWcegyH0pKJ7uxoFu64dE8Yv4xtLsphhx2meVYx/R1svJzH4EUkpdSiEv4FTWxt5CP0ItDaNGuyji3SBZayJ2NZHI0laM+eMVHWUy2aNLJKaQ0UJwS9H4k4o8o/46NshiTBizHZg9VKa85VwYEmwvznKAin6Kebcgl3oXmq10Uc+VGB3aFLj2qYzXfOadkg6ScSLT7jZyWQkziCaaYOcse5M91ol3Bv6wL1Bk5zxqGam8FiGl0ApUYIKodYmfGyXvCO2Fsm3n1VD2JWDuJSJWlpVKp4IGzLZVqF8WFAYjqB6F/xTbguEGYacDZOLRJpXCH7uKuoLuBnodMLZVLBcJaaMGzcyl5pz8NOuMGsdeDCxd4QQoALZWi6epxH2JnLSdaf7qaHvKnC/hSxpV0Ieg71TQObBKk9cAnBH19vkXq4AHoPBEUx3tVyOc8vRinJ8JiXCtIP15f5yD+90Ll+/oJPowbshT46hD1IIohFRiWXEZZ+9ElAH17uDMxMDSJzq30kHOensMULWwArNGIYV6Oe9ztHZdIQ9W53tcIJ0F4jTcUNdyiBg/08ajunpjJIZUwFHcqaRieGExFutFIbRTGxFni2+tRZgqHDNS5XGiqowzPfgJlBJp3xebTRYT2J8YuB+geRk9xHMCzQRFTYC4kmGA7xfjCLAFh42slDmgYTSzJO06gjWp9vE9RUzBtajpmHuAaHQYqUd1wiOrWA9zDduPoNw7mmoKqUmgtxK7ANESDNHL1pOXHO4h2BzuGUWGHDAGVlpqDi18CmUQr9bCVeoQwqcCSvCYwRlMd8LdBwMf9CDwxIIOze/TSAc2OHLMV6KtIkQUtUXdgrZCPuAOJR1w00Qb2NE5NxDGInjqEF7lTr/QPnYTVUwcZHgaUwZfrI4rXVxM4pUxX40OAn4I+Cz9/vlthCAMS0mwRbizWiQVJpr4zF+/6xuJAcdxOojmeKywVErFEmsmDi0g2T5zJXR1t5IslaICVaw5+O0rtdqRxVkFCXJg43c2H5en+IB3yOVuD3hJdFJGGZB9GX3+72KtCWgGwEHdJ5g/Xj8q2yeKQ0UQ8CILoWDIJ5samty65wmMUqTEwEuCZKqTXOrTd4wDQ2rnRGFY9CvRx4i7NEBESaNJT8UMkNMEI6wG/TiGHZf6NMBE5mkLxLSuFYfp5fCamKrF6I1gTN5YkKE+DBt14LAXMZ4IH83/U4y2mGg3p0ZwOjOYURFDHftoENzWLds34qFnIF2/yiHFTma4gG5UorqHWvAJW2Yb6U9Jx+y0Fj3wQyTN4+KqKpTQA3JISpnYK5a5fiqfOhTGVbH1QNXnInwoMEk8HrJ8A3NJ1VLZw9m0p1E/tMWWZNgfwqmiqV2Is3Dy7zHpzBJXK0BDGxZUfNT1SNC66n4QV4mpXqBU16jJtQIXDnEbiFgjFZsVdUoTB/65waXdrs18bLfNYcspoM5a7HdNZEi5hvo4TTg0UpmlErdNerYhU4UH/ZhDwBD3kr+2kaAV4vaxUxFfK9ETcCLuUELajeXFclRarpUgpVDAzpJFtRI2xEuNBjzxfMN9SjIod9v8udtgNscOOdnLKZAVCuN8a5MlArLpviE0/p9VGLpn2mM0Cc/A9ogMe5uswpyWOGv7jTHlAhpE9Ig6Nf3GYuIwbF0XX/G4OUTrezBOLQRbcE6VcJXpOO06mecofMQ6e2M4fj/HXPDIiATQh4A+mQ5QxdssmisOYRczDXZKg/fhwKTCThHCpP47QwgVoEY/JbGiXTOb8AyMxEgHLk2jGyeLjRy++eOQZcWEyPHOegTkojKh5cvTj+zB6BeEaU9vjCSk+6lFJGIKepCYieiXiFqGIaOHiiIOOYEngGOsCoQO30rGqi+bCF+fmfKJCjR7Rsl+JsxjeEFwQl4tshXpmS0usqJXgEvkDRTdpWujQCFzNPEIrJgNDTBIUyiRJhnOFND9/PKqYEujzZMABqWQ0sFpuxjFn1sAwtzJMuS4e9amA9fuDYAV2lHyBnqKg7zLIJONJuyhNex1TS3Wwpbpq3XCIXKtNh4meFEYRotleWrTksQMzj8lO6l7ybeBOaeGwv24Y5N76YWQvXPdMBMJflzwujbC+eMyWYggGpmiyBGD2zpi4MzQxU54owS2E5CA22gyGh4G9PPuWlWJWMDO8yDsS55rtsDkNxco4ZK3YZvi3iOPU+A6nolvoKJXfaJXOgVBGI1e0c8cp1T6aazWB6rkJIA0I810c4T6mxAJ5AMAl2LsLt4WOz8Wtd/KyxvAe/l4H+fAWVI7teO6UC/1X0GmCvm/BnC+oJ1BIXwf5CFVUyLXFjXVVBzxN45k80fvHhYeA2LgaSDG+IhOv6uJJdl2B0AVPUASLutA9gvz/uN0hEHpe5hE/IYWnKcbKZuRJwNgqkeYv0RSORz6OMlf/FcyEgGIY15JhvWK0Em4iZPDTZhLpcbIIgFRIEyXRhnfSwf3sAPBWVC9wlOJtfx0sqhsVXKkfdpKs7EFiKZxtUJipEpOmQocDLCsAU10yskA/acg87tLsIWY63Vz4pwlvZHPiPW6mDLDrozYbBBySnHrc3GE8I+MKBWmbFSAgVagA0YjX84/UMS5D/nr/ot/UKwuTMxwqGGlhMlGia0IixbORPE8N1YclWIaOzkkhtF7VUxNCuKGI5JJxictKHhh6DgU9s6LKAzhFWBnSVRBWXeRg35sD02n2OsYdjVI1oYw0pVS0q+qbwal46ECqyGMUkG/gRhtuUnDhwRh4ZpEjn1iFhQK5qANI82DSA1MnEPigQxaxD4HpvGhtrPenwcDK1KQys7kOty4pKgwzzTv1UHBQtgRlj3OVyrI96paXFQ1YUAKzudOk8KPM5M6tKv3AyuRZhHDd0VUKLlO+jWnRcxBIQT17CqnjfH8CcZ74soMSSxsphYyzLXSJyYlAcgqlhQe8m3MrI2Xa4gryMGIjIbhKvhVAQLwfi1E4guKJKhvfwidAO7i7Jvrn6VUk7w7xWlYUROtlRdeMQPiK4x4otPGiJ9rnPjQWChKgzWRyvKY0yXoouThcx+grBoPqEXViZrdDIwi1QBEWTEhfz71B4wwP9bC+8YZu5WIXBv1ijApDeQIKXGjCTyZOVbrfSqciV2th4SjmDFjFGOJQeVdEUG6VqAAs1gRS8uqOQ7Lo4DEQVr5t3Zsbw8iDAZi/JLybEEINeev1XSskSSq6zLk2lIaAfG3QTXa1Ee5GwXVu8uZ8hYdg6WRK5qktRA3v8/orejSXjeK3ttSO36LKz3GPVNOJJ7KryqLEkyyD2WtFXgtxKohSIMJ0uPTKyakVk7WhvObgOq6TvDqj4ePYBA8h99OGLvAxL/kHQsvx5KdECVsUNZ6YQyLP8EJ7zqUgxQgfET3zJCJ+kmHHAgLdDwMzyTkNpQTeFTWBwhc687CYRPM2qwyzmkieK0hAOOd3811ND7eQGS6VlJIxkcf9OfkWAOUC8GA0KYlGiehgIfKl0y+IOokmx5aYbXlnEOrHiX5Rzz0SHgXg5jELOFEWHlkqcU9v3GDnHjCUR5jPQmAqzYPflYemWdVFZwCRFx2OHI3xU4O0zDCFUIKwshZRthmYongd8AmqjBtMVvRYQvZHoI+PBb4YCn7jMvCn2nS4z2jVq28BcHdqVThmT+UJVowcsyASXI9pKIGv8GBaBbcuXQ4W2PvQQ8X8olRcHC6dCRcHZNlk0M4yJekm8SvhBo+eHIFOqrWgsnUc2xJZGPfq136rcP/43uxVaTzUhulZtc5F8BRuTjROREIrMZOhoQCGQf/U/UUuaqq1NBQq0xN8gKAvMlwGWgVJ0cEu8R4EcGAwHu8TIhmNhHyplUjH8YH+kCdkxbwtaR2Vkpn0It55Oypz9TtghOQpvAIf8KAUrziRl3+DIvIen2c+lddlptkW134T6cky5900IpD9dA4jRfvuZqP9cmBvGbSMOZEYz0EhhvM+ERMgPd4VgnpJHn66zIVqfIEnLCEQwLO/6JlPCjj4zqCYHR6DzRnzcfEEJDj9oURne+tJRFWRC0KKCUCVXE/GZAYypRM1YYrOkiRkKlJ+oBiDG+GOtLHD9GUjo5kFjxfE9GN0jBOqCLgwLXTGpUjz4SZvbhob1ia4c7As5YkwPRR57Y5mTcW8njxxKsooKhqTW6IeDWoU5/CqQ9jn6PxJNzldgogR5ijCT8Wz6PNtM833y/Nqn3kZTc1gc22QJMP2Uc2M45bp9ClKhA0ttNIDj0EDDXTS04Xjka528ruhQ26z0YcXzzwBUg9P0zBr8Dud6CxeTObopXCOTkF+yi3MVrGDwkdxqhGBAhTHTKehdgrypS4gtghfSEcXfQceSGbo1r9LMm5qBRQMcE3HNFcBZQxBfhLM2Qx+9CmsIRIKOTuSxEE03FPvRpLjbUAXKMOTA0UjC20Dc5LkwHNLpUCx3JuLTcUyP+RlBj/KrRDRlfY9A4zn1+KJpejkYBLl8tCbknEfcut68p3jebgsN4gkU/x8HnqDKpP31PqQCbf1sw5od1pk8nW9lORIg6G7TFksL12zIJqp/GxvXXe2BkIbXRQcicYHvvFLfcuU0yjZH4g95KJPzmPVO1yUD5zbFEC7yqMdYu5LGFgDLWGqCNxIxlYxLQi5yeOPG9SyCztcPMspz/ANfcCIUH9dfjgviKB+Ms9j7GV91Y3uD9TRtFoeaBkxHmgZtB2fjq41REYZCHsSafgZIV8Gz9slgX5idia30JZDUM1AqKbT7mm6vieQrAcBiw26Omr8aF8DFb3MARoNkaqUoIjaCEeMFyodD+zzARb5oS+N4W8T+HsFIUFT+NsMnTWQk2aoKv5k0uHOwjjva65mqhmlvhY01LoxnmYt+TZbK9MT4IZpaoqvNUlIrVQPF6WE/oJ9LG4yOqi2wo1ImIRP4rCsie68geVZo4P+NlCB3JSOuInZZYb9GdALpjbTXULahv2ZIcK5DLVt2Nc26ntox8TlwlUjDc34tDfJ1MaYQDy0mDZu1EwAPjxrCvDUn4VDQpkifEuH0tZUFV6qMr1UX7/Fs2LSayUyMblHtVVbhgAaaSC6AUBa0xS2hmHBFLbiU0hIlMiRSHeyaam24ZtNLDp4zFSLhj36aFhtUebLJAMjPxUuHb05+CD1BPHQ0VJ/BtcXMD16Pei2m7+/2t9WbUv7cS69zx5TtnbcaUq4HKr5yI4SVXlbQjdKCWdWU//CwnWaq8Ywj1dQTsiG3MiAwGtEfjktSwG5sFQYB3xt6KR5XyvcbsO87iT5MLUBdMTeO11ND/pbCwRqwxEknb+60cU34DJwVvR8MggS3UePBHxAwNaEgBxcanO0FhBmZBDETKloJH99fmqd/SbyTqGtGAGi+mp6H7E5kt6PJw1IBTpLrXPjJFObE+MN0q7fZZqPbTAtBuZiy49nVNc196aY98HXFEAFP1cA4kNhM9VPxLQxlTVW/Vjmh+UDZU306JJUNJ6mUpAOWgv1DDqmFOnkn2yl/QHUqv1MKMK0Dch1aX6kuMXfGMlfK346xxYkrZQzlkgxUkaiHjynUVN+7o8wV6FuTOexM0D6ZCKWuCJbU0okPkfkY9j2KX9mrZREmS9xLx2eksju4ss4PbDulRnoQ1tPtY/229V6MZmJMJDLlJmoZSkhJaed63ZNDwK+tlUzS9UMzOosSvS51V0OcB6KaSLEJmrjXiKG5wIylTrIiYBSkPGuNTEMv4d2OJXoBmKaWkckHiKYwXgpUiqNBx8Tc2pK0KMNE1hfhPBNifSaKVg9clcilsEJp4lfGKSGs43oJjd+johrGhFXzkGIxOpsBIdnrG0xPDdRJreeyNSjZwpArKkDLUq0AgXa8cVNlMnsOYH0qA3CB8m57ANUIyg1R+9TaLoNoUkr2t5oajYVtqWTHOrQ2RVAKIlpYBUkHemCCur0w4qqIPI1pCMELY8OLUAQgIQH4Nmall8GhxlfgRLXuxFu6HeAgMNf6RKXE7QaFDdBGSqNfpFoZyHNbgtog/9nhoB2iWMPFPPpI00DtFLNtB0ASJkW2uDxFW3IfcWXrDbHGs0J8rgGTQCMkf4zXWWyjA60+paLosv5dBKEoh/taByM4jCd02tK5imJRJYKFw1pv8zBc9egWBfHk/fo8ZEYnMpxV+G8CNNOYJYbOy5dfhQGzj7SfHGgF53/RVkfTVHHsd1h2B0Wg2niBEDjrFMHN0RJPAJSd45fzRPDYCNoe1pHSapE8jYeL/OdTFmp7EW1wCRzMKHFkp/7HZCD6zGmgCx1FsII1coP2TVCK6MWSdF/sb5Mxx7LIqpd4cIxgdPJwSkOVUD7XDTc1B4LTp5NM9oFIwkysFNAbu5Q848f14HHhUQ1TgeekwPPJdJu8hSb1DqGWln0AA5DZwvzcXNhHT+CaL+OMn/FHMyuB3fHYVrbXXQ5p6PkKrrkkAUZhMhM+XjNgmI8dpN5P+E5k2a9UoxpIQOfM37EpcLrrZm1UD+MultRR/ktvA1gRuLZPHeQ/Ap/Qp0LjJ8QOPzSoZesE3EzaA0vwbD/8ujlQrx0oYreQV4uHtPHO8glsbeV2EV0F+wgn+OXgaIOcjVektCxsHhhMZ3pVEwXfoqlxhNiLmCVICUiI0M5VRN3y/WX5vKX6LGVx2Ergaf00pKYJsW7K3ipqKvi3koxt45RjwNTBRQDCRP0USBQEiak+3FbAMOy5EBvtKkpeYj7PJYKobwBR95BPi1GrHSQj0QHT1PFm0M9qBNPonb5/wDdTmN6AD55e/FNvy0AGlQgGWcHfl190mGWlcl+y2TogzKBTv0KSBNUS35Amui3ckddDlIeuYCqIU+ULc5J1AHMKMETIP0M1TplQgf+OZ4GSMadCUrR5HbRyVBk4lDyMbgKY8D8FJNpIRhY3G5cq2jkp/7a+/KToPUzORXVAhQB/vGjoKnk5U8QFxPIuAm9d08OeOEhjClgnRxwTEAI5+N3cIjy5IBlgt+Sj+3gvTQ5INe6l4z74GUAQJTqn0btt8WMWzF2ZHDc4ogctJfqI+deDmiyzuO4Z0FfdKTFBAr9KEc7zhAGUImv+gg+3+M1uunw9JGqo8DvmMB7ozryRUfweGpK5YxSi8PFTyRz88RVDpXsamjFd8AdLkPo6vcC16A/NAMwH/i1gzQbdGo2un45/78Cb7SEFc/UYU2HJk6dAMBBfoB2Bb47BZQbrdgApRSqp2BKG9pa5rUpkgf+9vFb0+n4ejx2E3fYfFbyl4B208ifBYm/H1hBTw+tOyIxghfdUB8tXXz+ADgABH6udwrgBH1TeLDgxxXuxG5FT1ornspKhqpoPQeV4r4m9Ru3z3Ef3R2HQQS4giJFN9DWVDISkfET+PRygNu5Pwo/crgYg0EDjSgfWE1Njf0GnqlvMk1D8d9aMOClCQCsIq/qykb0BCegADkK4HECPYEpsBYEEiYj1PNVaz4RoAKKNUoN4ozk4463iwhzHkcxcZhWzARZOW8Q5/jSWWG4t1MPedHkPPi3Uc/0AtLdHPrM6VNkUy39SEiBmcJtRm44p2urT6HUPsb84snemPGtAQ4FfVPo2z3TMQCcH+gkwVd4EiOiEI58fvg60AmXQSdU+wQ+Wf9ELqwCfRmiL3wvir5WRE9rFH1j7iXjPhZ9yT0BQwmQPcUMvI+PUuIhOlCqDD5MtMXZ0FDAcdaBFwQMkZ2J5CyLQRihLQSgA3HZxc/yc0PXHTG47NBxOYYWuZ30QiyOGrjsMOEyCJ/+WjjPcZkZuGzjuIyZNKNEG/CgD++HmUgptDYD3j6e2oTORG5MRIiCSFSdLnKqyTOMKgYJVWgSDebBpQpBwijRE17qxBdWHO8l8VM8cKAv7+VxvdfIihjvpqljtdkv5aDkPVCiDZtEpB682XV4zZPs/095yW2Sl/5VWoJFbPFZXCKeEAHzEQYMUppC1ZLnd03AqHzaiQpkdZAr8B1j4HNJgOPMFO+LuUCn8vDHvjwNT1+PJA7ENDcQYK0Z74BlgkeQhCjsMAYxQCKbCEsnJyArNztbaYaCeKMQoXbwXUhd3gQcK+rpsaJ8zdt8hXeT3CZVNoEfpcnyyIzGV28Qc8HacAJxZ+9vTg2ttQdpHqJNDBFpiXKDB18XX1fQF1ty2ymAFMgWsHG9RYtRiZ+GygfSE0k+rG+e2LInKS14IrutL+1921VbnjH9fkuQ5gVoMG+0L8XmMzednGoRAjc1gn3EJUeFyMbzeCmd0K6Qi0hRL48ViCNRXDslrnGTvR+eyy4uPYo5yteFa1jQYjAgIvAGfYakT9SzCN0KFf4DH+nnobM2kFRhClSODQYkEY5AS+iaa0eZ8my8oaWEZIbuDJn0n1BEZTqK0HmzDgCqbKAG+k7rL1fytSmOP+5HvVF1hUDgKe6LCfVBNakOuoLAu7+Gi9XnosThKXzy/2Pag4pb6kJrUGM0BsDzWHXB8l/VBdVQFTAjhNKauQMoKapieTK+8oFDAZ7yD1v0D1txP0KnmDj3LtVqUEdiU7bgP/XERDmZ3hM8kZD3ROIClTHDeFqUaWZVRrtjuCSsOtbEajecr8JnevL9a445aBwVI0Tm+79oEr8VVAkIObkBcDdHzlf4+C47KwgMnQ9Yodwqyq1GOcWEB/0gQ1mJVtu4tiDrapwJtFZaVvyakmsTt1ME3eb8MPr699HXD5tePxz7Ol4FESEYNYQHwFhIzeNHRikgkoi0aEqghvLI2chFGPlrjMLhZz3r8/fdeI49dcNQKUH1cUQVPpng17M+ipZcxVBQ5EDHHxRVnFxd4cKKrScRdtvlpRSJ58VP4fH4aHWAO2/0jqgfF69wg5oLKkZVxo9fJUHFwo90oJOeyeSidyIDD5DRZTZ6l2CsYwDzSHycB8U4LTjOg/o4nQFvIEV1YrJtW8/0oHinB09g4+wgp/GPeA3ihX531HQaQSNFFOCutsIxjpdhCiv0WFHtgs3hxAVmTOBTahUESDapiVYxf1bS5U2aoqKTUa79WzEOArQDricC7ht6osKP/KFlgHmIuWao6Lq7EtUakf80IuHDamgh1v+qheBwTVoIi2ohTNdCrLFaiOLin8+glNcIweiUoWAZ1ZUYOrlwJZj3n+gJ6cIHxcKwoMuxrA8Kh+hWeB4+TH+JSovClRaFUkbxfUi/RYjvVuJRoIfwjAlUCzfwSSnxk/cvI1Tj7irmz7nFVyk95T9QeBen8A4Thcfuc3pJ5oKOJhrTh9OYQIASMZAzR590WLSN/wNjcOnk2MFzp8orsGpHyv0DdyX8DlPLo4NnB178j2xW56RQuUmQeLsSsHNeyPPx3MCBYkG5yYGqho7M1PE8v42zRpuBzjadHAVIL/tHdMYZt4Jqy9EZPmhCZ6uBzlYX58ruWJrEmbEDhCuBzjYDnW2XR2dSoaPobP1HdLaa0Nl2CTpbOB5b0OGdr3sTRlv/CaO5YFELoy14BJfQkMTQcKAoMNouh9TWKFLryritJ+nEZqS2Xh6puQQT+0W3+DAuI2EbEyYlvsYQOdL4SnDzdexw8XOPFJRcrfwVKrWKEcAHiFTz+XHz2XK4onqbUktvI13SytVLQzIyo7s1Kn0YxjfeBeUSRUemPIM6jyBszcCs5DFcojaPQA8dsv/ZTezBRezBhezBcQl7cHH24Pgn9uCI2rYuwyHESYXkRebgurSuEjtqq8SU25Rr2+IJ3orajHwU9Rz2fNFZ/p/jIbrPOc4r44uOcXSR9EVnMRad5b8uOvQvNS06ObroZH3RWS5ZdIzzEHYpD7HyrVtcaDJfaIwvNDu0py80QqI0leljERIKOR9efpXJJKHKxjqzcC0L1pkcXWeyvs5sdGiJSGJEiGL6oFt8l04jEQZovmJ4b/giY3y5MLHIHBzDSYqK0/GZjJb/hM8OSv5G+OzUrfgGNscRNschNjPEZl6ZsNmB+eXSuD1VYLNDx2YHYTMzY7PDhM2O2tjMYrGZXQ6bGV/vFoNFGkK4CZv/p+GcYzU3m6s2jsxw8c+GcyVKwlRFF490w7k1aji3GFYn2utXXKaDoFWFb8ntoS25ao9k10+jRKkA/VcYzzHllwFn/Hzx0ZHl3OF9Ao/tpaANoHZSVH2y9PHQsR9BHzOrDFJPfuaMWNsSl+/lWnzVbyP5XkKxXL6MfG/a0CFxDKrHbiEghkgo3xtZlt0YbMCtGvRRGeR7my542Qz5XkKhXdaFdgSUcRfgHqbkhQAz67fFVEVVAFaSzZDvrUK+h4mX9E7EyvcyuT72oh1X7kj7L/K9QmEIgPJ2RHkJUZ6/Q5sNNgx5S+Mf8fLDhmhwXt50GkEjBQskUmF0gRDLBInEpKLo88LXnswlIi5YcTUOcEEwDcQKwnU8/VSVyIIkspJO0Fe2HEDiZbK30HGSAXJAvUTZRI1OVzaNxlXJQJteeAaAYT41GVUTYvTR6Bcu0Uf5Fw7X/oI+pATUnIEocnQ1Iajyrwiq/AcElS+PoBzoOoIqHEGVGGu58i94qsQgn/L/DJ4yvS+XwVPlP+KpHIOnihlPJROeKv+Ep4rAU3YJnrouh4ExSCKZ0JVQU2Dx5V7k1h4+yQxnVzaRZRYrYQBlV2XOjSlBkGwQZRFDRGkvaKIlzvIknC+Jc0WJZi8BBQyZf1QIGAwFDBIeogKGfDkl1YaBd1EBw0YChoxKqi0fvSIw+zI0YxIwkPxxyQJjBQQUY/VUs1xv4wNUuKYqcXED0NEQNySUsi0cgGJsksBiRhKHTBKHzCUOmSurNpI4bIa6ylDikFHiQEuuRPUwXQ2XOMhSQgcVKNSD2t90i0+TlIMrg/GnFtEhQ0yXuPhO0HcIUzE3u6I3baBIldKFHdbluonxNOEaC3gLEgRO1BAcoPqN4lBm7+Qc2hPoFbOJESiio5nxPe8BfgKzn8fQsXtFzJl0DzbE81k/js4xklHlfr3KkGiVZ/93led4FQuDr5XESbYicdAcd5WQueQutWasC2ZFhxHz/UjuBUTHnXGejTuBvKbUheGszOA1ZV5TvlxNuQtDbJ3Oayq8pnK5mkoXpvDwAIUHFFi4Lz/pwDI+xCegCIt9XJDuJ6Cjs7D94Y4cXYzHCfNyrLQ2l8kiQFeOjjI3MdDx1LQFKAnJBuQOcooy6mMYJ5pAjXtKPuGN3qMCiadG6/cqb1XlmWMHo/SXwMNtFZ8QEhwTesR0KsZZjVex6FUo1JVR4mOqYjGqyHqVtoxdw+g4Qv5pGXc8ccImeCSuASoBtY9HP/MK/cLjFSbJikt8wG/rwrjJwjsZZ8lCJgOcWYXPlwXnyy6cvO0qRSZb8UfmoRcglToK4KW0yflcqyZ3IAff78YiR7TIgUXuy76FsZliQzz2LXI2lPiUwgTfwDMMEF5iN7B3VuQd+nAQHApHSoLKv3fdW0Ajv1zXvdgJ72W7HvtWTNfNb8V2PfGSrssCr80zofCVZ9Fzr/9z19MKaKou1/U07ITjsl2PfSum6+a3YruedEnXMY0Oxy6vjoqCdOBgmNSBUVLs5szakVk5onquYR5eL6ELS4hdg7yp6NpgrCMznBD5EuFVomuDsQ6MiUUhlgiv8j/WhkKiJoc67zKQR9efsqwUSTP0YB8AAJFBlP5wRsRtQOmjF8r8hy8TXoxYp1e0GxUVSrarP3fSc5Q28pByoU0RYF0jTQg8NHO2Y7Rf4tqkjPtXhVQu09t8uuhthbMt+kH5cqoolgMFRsV6RsU0/pPCf7z8B7Q/mFj9tdHG1UjjapjeFME8kJbvt6K8oFIO91e74cFp3hm4xYsGfomiYW0dFcF6xZXXuHIYVyo/BHYwjqsRJ43Mtd+iSDMkTCQE3GuTX+qmzn0BZZ0aO4g1IL9U1Ch9hPIHN8UIjxfyEY7d01p37/+n73dNT5g6vlMoIerOjKywtCzBpcvlNTV/83MKoZmcIDr2n1X6EOeB/8Konev/dXf+dtHz7bUyNDz3DWlSZVUfLRTufs3ikW9nznw2ApcDus+NH7D5Y3w6fdwpJenTg/SU/mzDSHm9oZlL27y+bcOb0NBd0qL00bYfsd72+Xc99UMLlgOXN7Sen9Gsi1IRMuV8LQurLDqOak1lK025pPxMNf77v99PvaH/o36iN9tqI5b9zR/LaaKMWUErNUAihD0Odbffm9K+6fNLykOltNslap2AWpvoRLvxsyJ+OkEb4RaCN/U3sikW3hrGAmuojForLS01GgjROTmrcLl1Y7el051rqSQphSYI4gTLJiAqpX5TmiULtF2KGxv4X/eS1J31QtIfXcPdp9yyuc7ozbcjLG4kmD2HMIM6hC101f1gp7nvn/hjzaZw9w9ef2vTM2d8XaH2q7c+VdxvxtL3Q2GCsRQuDYVc23yWuCK5MKnIokccrrPk+a1G0KiNZKRA2hg8RQEjsfBwlcDI0SpQLicJOyCHV9KhJ3RQAg+Dd+FaIs9uh+rKwwx4aGqyYzYsj07P7KDO4MnTqpKHbVygNigWvkImWxL6g196ghEe+I65+HG7PFHPgU1WnfX8gHR+KruaGCjqLU4pXu9L4Mflqgnccd7LD6kmj/V4TPwIKjAPWsAdcbdL9ejqo7tW9CId1o6ZEgPV+pjps9RpOskvSB3A/cuRQco4KlO6nziEHIXWw6gTieLTWY5KAX83CMSPzsyQMbs3MQ3pki9jvHIsGNCWrsajnyM/Tk6c8yDSp7UUYQJ05w2FMG8UfkfmirMNk//h4O3i7B3OZuxGxCENyq26gqo9T89QA+3QgHnSThqsnm7JzY/3cfNAmZih4tnyRRN9qYG2qjPPVyeQhT916VwMjLRSYPyFQTrnDT6JAav1+GN8Wl9cjscAHSv+ZAB0R2AW5TgEFgXGYG/8FA3D0QNjs5I9lD98AiXetov5JBOVm2u6buyhR81QBcLZ+ZcQlFRbT24+vmvYn1ArFCvhJZ5IlYdixYsUFev9Op6O34yg8ntrveat9RoehEA2VSJXfPYS4LX/N76MAlo88Vb+VZ9XT6gmsMRjQg9MyJ6HqnhDvnjlAnHEyv/oamy8GsGXPLF4LOJ/6XVsC2R04flJ0O9malDvO4eDV03y/kQ+ZXq/KrTwU+JSrfinbzSKfqORCxpptL6UH5QmlBQMJ/arhE9mjEWDB1mLge7UnQQ/dQvEhqtNrTPJ54PHjYLUuJrkkWq9jAE4daGSS/VhYAxiZECGd7wGSxhO9i8fGckw3rqHYQ/jeI0Ry54Az0YKD3pS/2ZwfPcIXBaElKfksZO5xhfPXTQ8uL1a7MATiTwYRh9PCi1mL8/jR8/EI9kEeS/Z9C6fOMzlwl+20cuiV8k4PXkiZYFxRHlDDH00zjvy88h1xAOKiPTH04YOb91u7pddlaNN47FJstE0ps33kPFJQTsU3DaIlyUmu/CRhGhaa6LsxAlUeQKZBxtR7n2AO3qFRVmuFyadpsBGaGHKAc5xqpSwzChgwqgB7A1TD8BPHpmdecZHIDLxVJga5DI6SM1IbdJ5pl0+MVhJTI4q1ChdZ9IVJNWWD3+iizIeaWI8wA5G5RFe2bQfU58fqYLH1PEGbfytQs7tjNNgbdEJoJ7wCkmUi8qNqp6bMy8nxxmjCXyPzoxNQyJP/RYZ7i+thznFFNXNA4A9lASK8xIQA5KJcYhEvY5gLDPtrLD/q+zP8/8Q+0u5LPtL/h+8T2T/cavxlFUi3ufmx4AingTSgM3VIkfjA8N7CDry3wioHCVN8iUEVF7/f0Y++bEaOmG5zFuxX03iB2oaKEM2WBeXj2LSvTn5aMUhkzzbkcFuDbiZm6JT8jrTAZlFODUmaPDV5iZboJ4nCd+TKfSP4zpmziIk46fpxsCS8JI3jpiB6Yv4EuPPUE0lXBiPuJBg/i4lBRHLRWRUteonpuBocKWost+TZ06CiAkQ5YBuKZYDFa/pRwEmqnIUf6CXcTeR7ZiII/D/PniOOSWJM45GDElBfsoUR7JE7CqmxyIQeSi3oKtWZJpqibdIssxsptjZxvzMKgsHbqJomAbix0WCWVnFPNHBbV5jqqgiZWREgz0GTTYhuYQn401QmwCxpFDxRB+Z9BKNWbIJ3owtkNBG9IjWpP8KGjVPMdsU8RWabKLL5DA/TdUE3ioel3iF2oTfiEXbhOSTGTj10g1iamQ+OIlngTX6TLG+xlBJKIx2ogl9WA+hha820b8qMCKBPsRx7AYeyyy+MwORMBGtJDaPbAIzeYD+g7qgQziIr9ljSgHatii0OX7JtcqJrBXh+LzUfU7Fptai6W7OYvjxiLQi9AkYyScAX6KM7iGCtbhwiAuj3cG83UK9XUn1roJ3fXhghdvy/weDxBjukMQlAYm2uMSpb25k7FzQKhIM3Y0MXSwqtCLJIp+Ul8xW4uvj9YuptbuBbxALsugiNqXmkQ0OjfCSObx4q8arnHJEI6BNI3Bwn8vLwrpxlMM3Fq01jpJBozW7PjxKUee+FM6N/zecG+twtiGcbQErPwqRoEus20fJmrz8GJDGmGJawtI1Eg5B4kMShatMpXDtwPGt048AA1nOPsH1fJxNQltpkWI+XDsL5LFoZjDuo7PJr6Atz2/RrXnWwB8HNxVbuJNUTY02IfDn1iY9KS7WGvjrjQVUhBJJN3Yb9RmROweNSZGQn3VvN/T++kPe2rsp5Lfx7gKClkafQncxXRu645ne1ExvXnvZN6+lN4vgTdpeueTjzopoE5WX/Xgl/7hMTZjfzDG9edmPV/KPz/BxF3kAw8aFP+tgsAbK//yMgwvBs7PY0tMj1+5hVlHh50nUwx3Ll72wJP5ErR4aT/E7ihk89GaO6c1rL/sm7+F0PjYrzNj32A/pcpCqZ4JU9WUhVc37YakNqXomSFVfFlLVvB+FBCnoxx9bv58HoCH0RQvmrO0fj8ka9L1hC+50nZ6QsNNWaM9ApHAIFBSbMfdhv6PUz3jeiJTJfidgbber0P6cMCEvkNibJwFTbbWkNttLPBqOS22ENpTZEkOmoOZg0TQrxaxg3SeOV9rMr1d2TRiK40pVVlqqf1SmU+5MX7wSs0fGkSCJmSh4jkT+MraGzW/uo16xataDncOY+j+mNRd1gJWqjlK+sgmH0IBu54evokGcDxauEZo8qI9rAd1q+B/7LLLHwp91m9nsiJ/VGjurNXbcrViPE+YVnnm2UkP+Dv/3t9G5tva7nRWVt2nQ1SF4MB8/5x7JIeYttuADSuBeROfHoAhCQUCUfcP8pou/RAEHKZMDJ6cEKeVyQPIeJknaQgSVB7V2KxrAQSYoI5Q4VhHIVEsedw8lGOplRCtlczrIVWiCNm0thMOq0r3w0Cd3d/n8h2vD3U891XL+jz/c/T7fLOg+/e/X7/iuwUddw90PDdlcLyS1QKPz8xe8iYmJD2mgT1H4d5h8PGUe9YMm8j7ckh8J8S0DSiMpRc3cuMkVLg2rUqlq1etq4VCp6wJIr1Habc6iQXQ7dgfmz63P1uDGSfSMBNyjf2bzKrF9YoDY+xkPxeOYJ0cxD/FOPNZ5gyp5P6ePKxP0HWlJZBhyGO2YH8IsfYGPV8Fz+ZLKq6j5S2tf4rW4V1aQd0nmzSa/rA9WMfps2jsoQyeXQEN0oclbH0rg24w1NS8TUMRN5GfaWtJfU3NgQrqP+jJl5ntjqwHiUfsYTRIhBUZCwH/dX6nDkj49eeH9cPfvRw5vvCQ8BWe+X73PvrylxdN4mfxuxqjpu2njZiQ1WKGFVIv+X3d1SLjbdU/thde99TP8Hw/04WZPQt6BD/x7C/DyvT0dBtz43Dq8dB75Yve0KZ9r/7bZRMel4Ii+IcYTBQOgn/crbplBl+hV6D+D+y2u7VbJUigcYD4xEKX4j4NbNVVaGT1V2C+rxn/dNfvjcZ0iQyKwDh574q4OLcLYqdOZXa9dMbQcR/q9ekvxjkEH8enPWzf8mbP/M3za982lr7JFX+DTTpN+e3/DXUMjIdXcbIPUq+/ov2AuMIGMr27J2/LTAqza6OqhxwY3rcDLF06s/vzeoW/gZftxp5ZWX/8tXjb+7kza8K4bY+FSat6Bk1QpXAYSlrRSzxoWOP3Ok5w1yzE9uH9VwZmzVa/BwJZd3/vRql71cfes1Wu9z5Rl3oOXKcr4O3x7H8DLkZmnffVazsbLCfXnH/I0fxAvfceCt7qvHoKXj0wev+nd59vnhHDBxXzl3i2rPqwKNa4Idz+7//s7cm/tjxtzb7y869S9ySPwcrg/c/brNw7Dy0VlO7+Py+qHl02PrQtYGl6Bl4Mnvvd9natol+/qYZ7BSVfNjoQ4VYsZTOsJ3Y6O7wCfGXps9bGCNdOxVz9e882eemfL8DLYZOHI9TVr8DLtlqfTTskr8DJudbr/tXsL8LLklgZNF9zetfYIumudjjx5U6cZ0PDSu9oEh1hKsE+ZZyclzz09Cy9X/LTtuoEp1P+7Vw4a4NzSDi+/fnjL+PeWncBOXz/ueGfRaVjg5h1EoHUgv4aQ9slAdE0zGuKJ+8WToxG+q6gftyOVYVopaRWS9XSYbldydDkzr/drcnQ2Pxsvnh2TLUhR5EL0H9AFX0ln6UBb1k8NBjTMcSATkTItNSArHwOxkUTGiXmOPmZ1DheY4MRTbyGBC+hUQi8TmYFRETmSiFsFmPcb7BEmf/ZW6lctleK1lNI0jNdz11Ia4hC6nZfi+b0tlRVrafx0XcKvWYg2bYlGhdFfoaWygUrwah1eEXypYI1REBIFVhj+CwFLQaCahl+9VrfNQLMhH2UxpkfNkVZ3az2nkHQ9SsqAx5V7j/Kuq7YIBs3Dh2iSLa7VyFARCgQVx6xu7FacMR1GF3IKIxhQgFvOOhCLwgI+ok61JupgbChKnMYZ0D1iwUqpV6Biacj0lBJTh6IUjbaajVPCwq6fZCs6MtBpwzP+ERP61OakhAI0u7UQQIlBAPlfEQAl8ei0Gy++uT2nfyxmoK9pN2mO3vCih4puT/dRMB9MYcVakUcghAACyVIXXwQWHDcmu1JMtsILDhsFe0UBPd4ucMuMEdYoRnB8QBzA9IY6UnB8kA18+D6KD2J6KSWJa+W/48PUKDqQz8D/m5jwu5VcWpAvmrNYXeLc8sfeRTMtQkK6H9M+4EzeZTphGMWF7lWd//i7W5s5OcN6mMStSsRtQIitRw7/DXIYOli+vm2LLpNwhKDKlfAuEHqfgkaW7pOzp11d1fnktT4KoTfKNSwvipZviioGrPvfM1vm9kr9zVCtKkEoej7kV2qJ9kptU7a83q8YHwz7KArG6FCYzyLKsYBmpfCv4D8ogn2vcKook7Rk8tuwxvrptN7qHLv+4nwQfjrf+uOcHZ/sReeL9V++9Ey9PSnIJh4e8DfI0ncjZz+HonRiacTM5P16CnoHGrSBGfitpeZD6+BJWVTmplimMC4LEuKQgoa564ge0U9WWRBnZYk6rpjcdqKHxXFvYXG/N8JBZxpkSH+LVXBpUSnlHjSmJY+EwB58tdtVcyIksMmBzhyLjE/i6ExvAbZgSFIYwevomR7FXCAJNbjbx9uyilEkx4h+1lJqOeTT04Ghm070O4T80Db3vPlFVpQZePQe6hE1+h82C8Q/KfYBigRK/3S/JUIqlwUJJVCHmgRKREJucMrt6X45gjKXarmZUoQT9GSqahPEkD+zYUjxZn7GnVjtFAr7t6uPaUFnpYSR4pju9Ot1eaR1R0kzboGUW8xS/bo888t4F20IN3zsJCf6HVy+d+qoKzMWAm0Wj3yJKw354zhVxVP/QuI3rDqBnuDbpvo0DqgPKjs2i62FxG8YNPwQ/lktgF7XmK0a4zRGEGNcbiZ0ftBiXCctIKjYBHPixEgQw3k5hXxmVm+RbjeTv0iIu5uJe+yWDBJ3KcryRO3XVBDDCHORQmg2tjDuAeN/WOVCBfEAG15X82vOSyoMXoJXMBpR6bCp0l6j0vbYShWmShuMSuuMSgyPQ1Lol8sqnGTreCF1ywIMcgRKimcEA6uLZ+hU04SfxE5AjzxWi6UWX6hht4jQLAcQK4q1dASq0YsT/ulFcbHe4+ItA/GuC2/SG6gsLCRvfIMH5xT6nd2ueuSF9X4OpQiNzdmtNfIKNgE4J3R17mada/rxhMdi/RaPQDF43qzpESzbJ8pK4WaucQM4FUKeJ9zh0H+N4Bcy4LeiwsS8S4zHczlYkXqgPGma0Au8q7iLpHCU5AgZdtqkGeRSC3+dhbD0/XzRKiQKWQJbpgSNBPuAijYqtAceGh8MzBzPc3XiuTc1M9DER0temgNAKirUp2hc/9hTG23G9GggK6nOmz3cWcGGLxqF4xG9neTAinf9eRCzhCTVqFON8xs15dOihu9rMBnSxJhq/Xumc9qDAlVs1wjGlJzPxk1JcatgpcveU2T0kHqm40FIMhbJpuMeyxIoJZLxFg6cv+J3YJsGWtkRjLgzY8ZYnw0PceoZSCrwObjtD8EXAyVL4H07Cgux0CKVv9jbBx4/pD/u39MsUEYlSNw3jcVq85oxYbjNpctmOaCYUfYPKl536IuFgPCyCWfF/DgKDT0OQGVgPyZGCGz/VmCx3x2OpU6Eqljq94T98bQXzdeSl5D1W0JQa+Dwt8bywfN13CBOAjkO+5NCuCri8CjHBJghN8h5SWq86sEl4gGUp1bm6q1UGq2ouNccRzhPKwo+HkfEXEjS3+qLZ8O3pjW1zni85luxpvgSNJ6vEM9D/njo2SYdfnHQG7FMaAVZDWWCJnq73TTRkShGOQBBoRgUC/KUoXNRozjpMCbVEdUcVFcpcqR4zNWPQi8OElZACPfChTJpUiURdsRhTKokM6mSnpCuS3ImdnldUvonXTIOxmxoDvZLdUm7SZcE7H+1kPRJWdjjKQLQe1qMTI5gWDJ8LESHkLkGoA10Bk/WrzKTmkYGwIBMrupvOvhZSKAzwTUKSnP8Cqx1VWcQdCIR3N2cziOsdkjcHPZ/T0v1SzHaycpY9cSoWVxcNCuiXm7io2rk0HS/NYTpGnUtBv04EG+BI/qZ2UKeXluNeU1iIm6o2NHbtOxBmiSRTQKA9aNw54emBn2SrlEYVaDgYl36p086kHWsgjCC2tebWhus6K1tGN+XWvvYLqrGVIGC6pH0zw3pgaUJlDQaH+qSMCjgpgN5/qNRm+sbtS3ZQO64+Zhd3pbN/rMt2zBEM/dlTNwsxpQdNXGzGGO2buJmMbZs5npLUZDJKoW1t1sv0CgDa9Y8XqP08VvRmczscc/QXR53OPy29FLhZv9QNvK5VSo8CdH2SaPJPkvUFCG59FABkO1AxO0+lHYTDmm4p+VAUQ8FXvFf94m3Df5y56RfQC17fmnH0NwZKaiASblnzx7ufh1eZiq3f+wfMwYvO35qm31u2ON4+cDfqKJt1kJ4bqTR1sEHIgXjW/zZNdz9xAvVVyZsSMKqI72L6v/WNAsvU2dV/r39yzvwctnssSe+azoTL/8OvJn+XunLGjngS/QXxKYQ+dFjtleJAknz1vvpfD/8EMhbUKkMBG64CZX6navw2F/O3+UeJuKqOsuQlkVtjrjp5ozeOnFLDkma06RpUg/Qs8vpevr/EEmLL4OkVf8LSaPIidZrHaEoEYP+ci2kcu2dJuEJU67t00aNHZY7lY3NHZKfO7GAFQwZP2jouElj4So3f4y4HJ8/bvio0bn63eghQ3PH5MLVmDGDxufmD5o0dlQBm5I7asTIAjYuv2DkuEEj+U3u1CFDC9jw0UPgpVFTc0dPpOpjxqhXjGgFf7uouVPH5w4tyB2mjh83cVTBqMm56thJY+7PzZ/IhhSoY8ZNLFCvGKaOGQJdGTVk9OUfquOGq+2u7Kjmjxo7YiIbO04dkztmXP40dfi4fHWIOix34qgRY3PzsdYVD6j3TyvIvbSSGF5MHXg6LX/ImFHD1FET1XwY97BW6pRRMLZJBXBbMKRg1LixKrwdHFUAHWETC3LHM/05wzGy3GEjcvF3GP2TO75g5CDoy5gheDs6d3Lu6Cis8Rt9bxt02223Dere46bbelyjtlcLxqnt20cBRD0dq44aM2REbutx4wvgYrSal5s/FtqJjqcAr4ZMnJSfqxaMzL1s+fBRBTBkUYKV9NGPHDd62EQV6o7GuVNHjYXvTVOHjhwyFmuOGTcM/h0GEGcjJo0aljsoj00ZNaxgZCuVzzXMCUzpMNOUtsOvwUzlDhk6krUeNXY4u2IiTDqOdey4AmPGGe8KvZs/ZNioSRM5gvxbPURN+iAgIYwKr0Q/8YPixeGjAC1zddwVM4DDYMOHwD/5ucNHQ0eHjB2ay+Aljp80xdgGTM1EdeLIcVPU+4eMHTaxizpyyOjhKqyQcaMn4RS3MirBvBAUObYwPgTRDRjFmDHXiJ60UrMQIu1yO7cCyEL52KH5MFeAtoBy8Lh1ZxXwezQ8KjCAaEIRHDcgwLhhw8QaiVYiuHbBryHER0QLJhbkw1RRT4ZdA5+HvgIa5EYrGNiH5cbXcdIuW8OY0ku7J2pA91px5MVJge+Z0Tr6npjo8VM5lODb94+DxZ/VStWXOIApWv1y0wzjncjpCG+BAMjhS+DVgR1t5dZBw3CJ58OkXoox2ESteWqfZQIxvRpDxFrBmpw8aFjuiPzc3In0STPtU4GcqhNzC65RiQiOnqaOG0szMTY3dxg0aGAzYNZEHZla8ekpgJ4RUk0cCZia32yiakaD2gvBKNARH3EYVq+YrJjqpmb02rE4NTx/3BjjTbHMarUbJSwTm2GtoTA7ufn3tBsItH/UiFFj8Uo8yzKe4dUkwpKbBtx4I0MCNm7sRONetGfc84G37ipWVbTgitrvII4ZRD72deN28pDRk3KNuyhLyDdoX0zNe64YNrD2V4iyAdUm+k4V4G3jwaAhU0dN1F+7P3faOECGdrkdzC+PGz4csAHQRq+GCMfxOksdMwkw/n6O/6NHCzwklBqLWHN/7mjA2SxmxrcogRTTkgkvt+uU1ZyNHTKWMSS38OcmC2PXwN9cK9xIFofbW7dB28DdEx9ntf9clUM/xbfnsMv+qdQu/3yvxg+1+VzTT5Dmv6eM+gr8tYi/Nvg76/cw637TWPZX81S2745m7KurzrP7v6xg2SsfY4GS69jQW/5mG79+ma0fso11GduE7e/bjfWxVTLnyTYsY+k+dqrB36z56xnseNcX2PmrZ7LuG9uwp07MZm81Hc8CMwaxT5d0ZrfN6syeOteZLRg0m2X+voldaHQN+7rmCZawwsoS21axuLsXsDGNxrBPZnRgzp3NWM9+69kzwzXW+uQg9l6zSeyHUx+xax/8mf3W2c6W3jqf/Zl3kjV6fRBzDFzEspTb2YN/9WTVL+cxtfwT1uHcKvbdiw3YfUOWMEf6j+zhlbkslDKILcoZyYoP17BmE/sym60d23F7Kvt4zUT24NHBLG9hBav3QS+2e8RW5jx+hN01qwVbMPkD9nzG46z72q9YvTv2see6WpnVXsPaz9DYliuPsxX9vmYbp1/Jml67lTXMq2KrL9zHrm7UhRWd3cF+fqQBKyzxsWCTQnZo7B8sq/UUlnrNdeztlA/Z1npPs1c/2MJa9Q0wNxvI5kzvyb6b0Jo9+eEq1v5+xt7aX8jeeuEJ1nHAIfZZ119ZmTeN9Z38Fxv2dAs2/rOX2dDCC+yBdXewuqnHWEWf29k1n37OXpjdiTVpvJN9On8Ku7t/Y8Yavct+jktn9fZ8w1a3q2HDGwbZyjuGsFf+7MVmFB1m/tz17Mrj89iPkcGs6oPdbHQHJxuoHWR1vv6M3XnN1+zrJ5ey/f5MljnnODt6Z1/24Y4rmeO7Oqxy+k5Wt+Jm9kuDF1ha5T2sTfJVbFbS/WxWb4mdf/Qe9uq6ItbwxFnW+/rrmHfEAfbSV4fZa4O6seCQPSwu81l2YOVbzPb8WXbvlCJWtmUWG5I9l82fOJWtXXg3G/fZJtb6+aHsXGQnW/RQFWu6eQQbsKMH2/F5B5a5Zj/bMmQRS/p4CrM0TWFJPZ9kH9z1Adu+rTvr+8YSxur+wg5e9ypr3ucHdvGQl7H3/2INl+9i4/ecYcldz7PTPxezN49tZR9dyGTLrMvZ5gldWRvnm8zV4xc2N+kp9rL6IGvz9mrWa+kW9uCVbZl7wBiW/0IJyzvWiLXb+TibVud6Fph2lJ37Zh47vvwJdvTH2WxluyfY3J/y2KBBHdjGi/Gs96q32IhnR7MJ+d3YooFXstWpG1j5D062qN0V7LeCzizLmsE8bond4BjJWp25k/V6qYQVHJPZpk+bsN+mP8/G9s5nq+tUsUeXP8/eWvIr23fbLeyTuLNMXdGenb9hBnsDxLavug5iOQMV9vC8Ijbg1uas47AKNuawl13Z+0p2z42T2E0TDrIe/ccyl3Mza3F+FEsZfog1sz/NBlpuZm9d8yU7OXkbe+T3uqxP3nTWoNl77PFRzdmHu15hr6b0ZyVHg2zu5/NYq/ybmeXZ99kU+3L2S9Z4xv5qxk5OWMOGb+nDhlVey574ahYr055g1y2/yDxzFrJ2ga/Z0s5Ps6/GL2R11x9jjm+uYakdW7J7i0Ps7uJlzJu4lCUcP8xGF69lX9bcwDqVJLC70iaz+59LZUN2bmQfzXuXeXM2sf1nLazPpGbs1Du/si/9G1lcyktsXtO2bNisycx5TXsWv7w+u6XLS6xB2Ra29qfX2L1Nk9iYLX1Z6weeYhW3P8EUbRZzVv/KWuYsZGParWSd37Izt5rKDm+9h51f+gH78NUb2E07nmMvdNzNfnyxA3t56XL2VbeRrN7Qr9nkhVVs5IJb2V9fdmSvlb7Mvkltx+CCuf/8gg3rO5z9ZF3PmudmsTtuj7BeNV1Y8Pd32aT3f2GZy75hLxcDJ1j4K7PsTGV/+G3s8+8bsGvffJbdkb6YddjtZDd1O8GS33+WtW/8Nqt+qT7rl7uG7d/8HHNpCeyeqbtZ498nswcXWNi8uvnsw+dvY+PGHmVVpxh78vo72QdfrGcvDX+PTf7kE7ZPbsBe/7k1W7hyM9v66hQ2p/cX7LeBIfZh8Tn2SnVb9tXpVUy7t5zt/XoMK/moEWvx5Tus7IoujK1dxV69bRl75w4La976LXZD8Qz2hf0FNvmlePbgXaWsTlILdmR9a/bHDxfZvC//ZvPev8i+nzya2V78i3UtHs8eHpvKLj5SwzK72tmQEe1Zi7Q5rO+mk7Ce1rLFY8ayx0Z0Zu0i97DZn/VmWd/UYR+1vo5dMeRq9vH4PSxr5wYWGX2RPcvCzDr6e3b3VyHmG9eL3Z+0n71772w2fkgflnd7JVt5q8RuHtCRNTy0nrX/+QOWPHYQG5j1PXu4zYuswRtbWemVHZhj/bPs5OtAo37zscWjvmfNaqYwt1IMdL0167c7xNTnVrI3wwdY24Fx7K3fu7HEL3ay6e/vZU9+uZm9XHcT2xF+iDmC97I2A+qyZmwAK0qpZt/a57AU1zD2eGARe+T9r9kXF1uwvCveYQ/Ou4pZf/mbvRt5ho0M9mPXt1jD+n1wN2t9oZx9dvcKdu6jx5in7yKmdnmePXvHIJaivc6KOz3GdqkSm/DVHPbx1++wyODzrG9uIpPseWzhulfYGxV72S0DerOGf8azx/K3sjLbNawi52pmO/Igq+yxi93U/A/26Y7t7PgvAVY47Gv25LDD7PP327Fnn9jKptx5kI36bhur/iKZvdclm/VM68kGTBrE9m86z8Yu/ZC90mYgi+/+E8vo2o0N+eAR1vziCXbs01+Yv3AHG7fkauao3MZqPlvExgaPsnUXP2TLHJtZ4cAClvfqG2z32KdZ1/wH2YeJQfbbJy+y5hO/YW9//B5bz25hR9/wsIL3mrAfpg9mBYfnM09qK/ZQmpvNGL6cSc3rsNUPTGYXL77Pbu9RxT4H3n3682S24L132QdP/MXarWnGfh67lS3f1oEdXnM7e2vN2+yTXfEsaV5rNu6Oq1ir2+exlXu+Y5+q77K8+15iXVs8xRIH7WIXXdezb8/9yR69Zgw7OqcVO3FwNvvrrRdZ1Zl9rM3VH7O2nYewTr7uLP3z7eyhv+LYn9cHWduMw+y2t2azm1YuZP39u1iLAUdYxYefMle9x1n98RvYqMeGsaZ3D2barWdYUWICO/d2Ivtr53l2VXlr+HuGHR+4i31132A24tEn2dL2VezjuhvYkDufZN/eUc5umfUhO9zVy76a0Ju1zviKrU0rZb5WPdldv3zGPn9gBXumfwXrN+cPdrvtL/bDtNfYPH8H1ulVPxux7AgbcPwlNrNpJ7bj2JPsFs+zbGX719mLn8WzUdbeLPeNalY09wU298Yn2O/7OjDf0jfZgzOvZys+8bGc1UfYkV4D2LcFXdiIU93Y309/w+47OIg9OOJZ9t4rD7ABv4ZZy7mNWeC9AeyusQ7mazGHde41i8377kf2wzMHWZ8/c1jN7SdYRsIOtu2u+Wz5Hy3Zgc3bWMK2T9iXd7/Gem2bwx6+7n7mm3MNazVtOfMOeYS1uPFBVtyqPrsuksTmNi1hU7PnsTUffM9++PJB9kGXLazpuZPstxGAA0sjLLesJbt22etsU6GLPXvLEdbsq6Fs1LdfsVXL67E1zR9jI/dkMudPb7Huq1V204odbPzMoWxGYWOW8O6V7IXzj7KU248x388O9jbINONm9GXP1buFvf37y2zmN5+yx78awup0kOGbq9mscCnL/2kM67zoATZzw4ss78p7Wc9m94B4/BPbz6awv84NYNJdfVnlhGKzEJyDESh40bp7QVeUolf0vJCNBu1bdk29Bu9npVd3xnrqFQ90wnv/zO86YP0Gv4y6mvvdjMjRAxoYQz+gyZEu1zxTvuo396ZNF9FS+I2W3Z97di9pWfcTzFFSd++zI9BtnL+3vRv3H/pRa/LBzJpNkT3a2+fcnznyXtF23dxz/8tvzNJmd7npycrPBtSS46u1sZG59ftd82T21e3/fPHaX6u0gUcOP5U8eEL5kOIpXVedrtL2DX/E+8B9JeUPF409nvpdlZb864irb92/MLvg4dQD6z6v0v549PfGxXsWlH/961fN8/ZWaUO2/zjkpt8GZ29/clJaj4+qtJUH2t/zfVlJ9qxfPtzR9f0qbcyDswY+v+qJ7IR5v4++8+0q7a+qi0vrv/1o9m+98lsufQW+91Tb8de+3zU7vO/AlafLqjTX2JJ5VynB8vQDf68d/mSVFr+pbYtbb3+s/JZ7kvZKy6q0ASdvWlhVfHP5rnajKzbNr9LqnDv0buOPl5RXtn7xtVUzq7S1A+498d2B4uxbHn1u+4oHqrTey547mZpeXP7gLdOzN+RXadde+fWA6kaLy08uWtjp92CVFrktWVs4b0H2pJ3jTt0ztEpreipx8lOfP15+8F7L7Mp7qrTBbbt0/e30quyX3h3Z7pH+VdrTnebsnHlscXmDz//y39y3Slu09fnugXHzsz9deP/ca3pWadMt36+zPlCc/fiR6Uv6aFXa8jVrvrv46OPZne6fNPaBTlDeu+Bs2n2PZGvPv9FvT7sq7eyxRita9irO/qrwaG6PllXafY4J2oMbHi9/aOj5b79pUqW1e9k55tvfZmZ/+3Wj8083BPhHxtV/0ndtecnnX+wtSqvS3opz58/suCDbpXz//MNJVdrinXvmLU0Zm317264vrnVXae+8vK7vpL6zslPXt4v721al3VjwylGp25zsdodv/Gu8VKVdf+HAwM5fLc6uqTPsDcdfZzTLPY9eU1w2p/zn1UsHbfv1jDby5ht2/XT90vKdL3bp+MLPZ7RHW9+SfsG+snz4YeuY106f0fZ3WN71+L4J5b+t/uGqL4+d0VLT97xZr97K8h/WJG9t/d0ZbcyNLV7ovfrhbP9VSTc+//UZbf6ozAcGJy0rzyh+xdLjizPaPfPq9l78wp3lLdr85ov79IyWvqrPiCdbFZY/sebmz8/vO6MlvrJl8E9Dr8tuPW/IYMeeM1rVMNs1zuGPZ9/BGvwU2HFGm6aUfvHtrrHZe7M3vx3+8IyWlZSgPVqzLPvrA59Vt9h6Rlu39oGNe0omZzdr0eHQF5Ez2pTK/qc2NViW7fnq4so3ymE8ZRPYVcsXl7/Q6unJb7x7RutTtuzIrq8fKe82/JPwF++c0QZ1Stj04ddTy2f2e/r2lm+d0X6998HTPZPmlCcsHbjj2dfh/c8uplmvXpb9RbO3O/Rae0azPjm/7foVD2Zf/OiJg0mvntGc/TOOfju0JLt5/95f2V8+o538sN7ND390Vfb6nnfNb/riGe3qimEtf7xyeXZv36up4144o62evHLI9d8vLHcemfzut8+d0db0rbpmW/uF5Q8P6LJuxrNntNdOtJw39bbZ5erWXVf1LDuj3Xnn7VO/2rOs/Ar/gJmdwme0YfVmFL/kvSN74os3HhxQekbL9N8XqXpzWfnua4qGPxM6o81896pHXk0Klke+cE1KgvszL47ZUDViaHnb+rnZb6w+o90yt7L/tUeKy2cvv+X36XD/Sde7ZwxrNLW8YNDp45Pgft30BRXXn5lTXvDQc71Xwf38Hwc0vLLenPKPR3S7/RTcHzjovG/nUyXZ2sCv+42C9hs81/fdI1c+WP6IdGpiCvQnr2JE/4unl2dfuTlL+gnuB4z+9OVvT+Vm33/TJx1+gf53++TNtttK55Yn1e/avxmM96qO1/z8zqhl5cl7blw5D+DRsKZel9n3FZe/+lHjnvUBXmPvyD9888Hl5T8t7f7k52vOaGx+/D0jXi3JXjl8/ucfvXRGe+tk9ea26xdlfxlq0e2HV85oNce2PTX4ndzyhd3frnMlzFf3Qb/cNevXB7M7TEld+RrM56xrG77QyLms/MOaJa57YL6bNxy9YMOLA8t/2LZ7Xcf1Z7S73i0p/L3x6PKEW7fv7P7eGe2l38/5r7tuafnNN329euamM9oNjw7/bPSOh8vfs+8Y/3PFGa3ZniUt/1o7Ibukumzmkg/OaBsnxn179f4x2Y0bf1dv6PYz2lD//X7LtkfKc38Y+ODwXWe0Q+2OfjcnY0F2+9bXn35yL6ynjeUH9m1cUj7wiq5vKIdgvbU781S7XSXZd76ZlfzM52e0N++eOHb2qNnZkYvTBuTB+nrr6Uef2P3NzPIHfjkQyYP190j7nUun1F+Y/eqBu1euPn5G++PzfdcvfrCkfPg7i5rbz5zR3nvtyO2fbx1Q/mdqvw3hX85oOb8+f238syXlXe76YVH+7wD/Za92OvfpyPJe9/15dnIN4Ov8O/OOnllSfr2tNGudtUrb/dWguM9qCrL3b76hpCHQm1dWLP3jz01Lyp0NP7tnC9CjN91rs14bOzH7qVsf/urJekAPL66+98rvHs1+YG/NoJdVqH+Xc9/iytnZN+y7o83Pzaq0EfVv6rR299Dst4/Zlo9pW6WNrLd0dKu8EdmjSqqOqB2rtP1v75qVNr+4/I+tAwe4gL6O+6NGG/jq4vLCefbrW/eq0vq8OKnTa56S8rPzPI5H+lVpL9ivff7hsoLsR57980janVVagj9HfWbJzPIVsz6u891g+P7SzYduvvvR7Iev/FL5cVSVdkOe9MpdXWZnD35L+sU3sUpr1PUtu+/QzPJBTz7Y/onCKu1jT69r3m0xr7x56fmUnnOqtANzuwy2vFOQ/au24FibkiptQv7Tt5zeNit71o0f/XnLqiqtesmBxUm/LS7/ouTZ8Npngf4XND664rVF5T+PeLR177VVmkN9KVC+9dHsZncPOZP+XpV25akXty5vOTv7iffyOrbcVqWdeXhfuxeHzc/O6TH2nsnAb3/67prv3+v4aHnK+0+9evFL4Ee7l/S9Zt6U7MMlzzy0+ViVNm/X4MBm623ZP09Y3HLLL1Ua68TlhKwRHy2745c210rCZfWerFtor7ekxymQNz6JJEo/N3lz5cfa6u22HyYN2BbRXVuniD3hnSSXfBJxf/XYypVQ74UeIyhKLevr7mVN+mzRcq/t9mxNTSSy49MWmbMnlGs1I9ddd2rlu5GH9679beZD67XdPfZNSr717cjqryu3Vl/1m8ZKfpxWtOuzSKMTrYJTk+GeebacGfdZJPT2H47BZ3/VWOUtyd8lfxaZvjC50fP74H5qZqd7Nnwa2ffWNlef1/G+uGTAwE8j77nbtu+1BO5Z2uS98qeRxt38aasnwH1JyZwdaw5FPm/43Mp+t8L9zcrt1/U7FPmgyeKXbm8P9zl5Wzv+ejCScuTpvDdTsHzNxReePhi58d4Pbx3263mNrZnXeWmPg5F+rZa8PeIw3G9Y1/ncTwciX5fcs7P8Pbgfv7j7nscPRKbW//zskKfhPrSpbsOcA5FHbu+ZdHsx3Bf3rDp6Yn/kQN6xPU8MhfvKrE7py/dHlhW9cPSKXnA/94uF27ruj8zqYetW0wLuS5o1//bEvsg3m9740p8A9xd6txzz2L7IZ19f1WvxL+fg/t1VIwL7IjmZX39y3WG4X1G1fO9PeyPby6ZWdN0E994v055btTcy/4rKrUVhuN8w9NYfe+2NXDX7YBPrXLivntPDf+qTiKt1vfQ9Y+B+Xd1J1/f6JNI/rfOBz2+D+yzvtd2f3RO5e/Zb3Zt1wfIT3T3ynsifF1IDb6v4/pTm4cG7I6+f6/rFTDvclzxmkSp2RRb/fcfAxWd+ge/Pu725uity4kZX6PNDeP/QoroP7Yy03OytGLwJ7vce2PXx0R2RDV9MatnkObgvSWqT02NHRN67erd/EdxXNxg5Zc3HkYwHZm+7ZxLcZ/UeNcb9ceRoh1f77BkI9xU9nlcnbI/kHOy7YlpPLE95a/GnH0Wa7KzZc29buB9/f/aG7I8ifTylk6akwf3gjk+uKvswUtK5a8ftEtyH1vdv5/owErjw2MabTp2F95tMnj5xW2Tfi/XkuEN4v2Xxg0c+iLS4uH7N7+/DPdt/S6ueH0ReTnc/kPEi3s8qn79uayTr7ZTB+cvwvk/eyvStkfOld9zxx3S4z3m2pP8jWyKRaxo8+eZIuA9Nu/DuL5sjm84vnvX0bXjf6ortgzdHrnF8/NL6rnCv/nZH0Z6KyDs5L7aUWmD5332OZFdErgzsenxaKtwX31C+6Y5I5Mm/9jdQJWw/53FHx/cjrt59+5w7/TPc/951Rd1NkVG5i289fxjuQ4dvGvH7xkjhjDsSG2+D+8Ft1WlH3oucaLqzoPB1uC/OPLa14t3IO/VbuaVn4L4i/82ez2+IbBr/zoPr5sM9e+VNadH6yDvlVVfMn4L3nXr8XPBO5It2N169aBi+/8iY+Pvejnw1qFnJu7fAfWXp1/f2fity4/4rn43X8PvBvp+3fzPyxe/e/AWt8PvbLkxT34i0e/t0ZlZ9uFfvX9Ez/vXI2qtmf/GnHdvfHxz9x9rIm3k3JZw5Xw3jmXL9oi9ejexZ3WKg7Xu4Zw9/f7r85YjvuVZDu++H+4qknHmlL0bqrzha+EIF3svt75z7QmRfhw9ntV0L98WfjrhvwnORzsmhFV8+jfe5febfWxb55tita19eiO2nDvuuT2nkz8yb2q5+EMtPzazIfyZSb/HVC98O4v2tt/48YFWk1e+nnztzF94/9Mn91z4eKWm1b3efPtiflxb+mbk08uKr1R9+2Anvf1cfbLcw8uKV05JzM6l84NX1Zkd6TzzZrEka3p/eoiRNjTz2eorN4sD7JtOclsGR+n80/a1RJdBlVjL7l6pxWsHJIVsySvH+2qsDRx7R2qx8aJ0X9BBWvOWDsj3LtN2vnsn+9Qosn5eyefWT2rHkJcr2EyDnsMQ9h9eVai+/vnNq8WtwXyHtvWf+c9qT7qfD9Qvgvvhwzqx7X9TeXhk3a0kXvL+jKtjsVe32VYOdlRLWX/HDiknrtBUbp/wg7fgJ5sfz3fnb3tCUJYWus0t/wvlf8FWbt7Q99/45/JV74b7ijkfusr2jPf31fS+1aoblwasnfwF0vVVe17FnT8N8Z9x03cvvavK0F8Jj3sd7z8aPpm7Uxjg6jmm6AO7VY1cmX7dJs9w5cNPyO7H86wnt4iLawtUb27/dFO5zlrRMHVGhacdOn5l1/hTQn6UzH+61Wdv8+JeTLn4A91k7do9tukXLvH6Ou+FjcH/ztuc/U7ZqrbpWbTuaC/fe9tlbv9mqLZj78YjeHeG++IG8Du99oF2f1cB3gxPuq/dldl62TZtRdfbh41+ehPu0JruDH2rhawe3a7AW7kuGn76Q85H2wp0HtB9nYnn98xWp27UFE51VOXfAffGv/Zuf2K41u+Hlkhat4D7ngtxh48favrPLkkMS3LNWGT8t2KGlZ3/ZZPVnJ4DeSffecs9OreT1j6xXvAb3FeW7RjTfpbXd88TZNg/D/eDeh67+dZc26YZnz7x3L5b3vGrT5t1ap97Hnv7wKriv/GSDtHCP9uOtI9r288B9Sd0K54BPtKc/q3n01h+PA31vlDQ6fq9WyHat3hOB+73L4jdM2KvFb33/i4qVcD9+zjN5B/dqf9Zt/FKzAiy/of0jHfZpjlVvvsL6wX3vxiM8K/ZpA7rmHu/TAu6Ld1XWXNinDZbPPSbZ4H7k0M8G3bVfa15WOfSKo8eAH6Y4s97dr7369pEpb74P94Ov8+anHdC2XPHEiJeehPu002OaTjmg3WGre9Y+De6z1v7Z79ABzZ386Zc7bof7yrbfnbnyoJb3Tj+JeX/Usu/ptmS0PCP7sbf6KizrRy0wkPU+GVmUPfXgcg+7+Udt/XOfznmh6NHsV8fdZGfjf9RuvKJ/3sm/hmS/lvDN3zWLf9Quxt91Y7MZheXl24ba2bofNemLI71Hbp5f/uvmexuyvT9qicv6PJ2hzcru+qv1VE3Vj9ptrY/WtxTPKC9+Yk488x7Tbp3mnDC85sHspBMj/qppe0xr8simpkfZwuxg4kPf1PQ7pu2Xfh67RB5bXvLUiAQ2/phW8FT/3RP+GlF+9fYZf9QsPqbNspx/ZvP7D2X/uEX9u2btMS132K7mdWeML2cfaz/VfHJMy1jwoCO/uLh8cv2mJ2qqjmmv/f70mMyKRdnHy56yMO9xrf2NP9yyv2he9uJWy+qyrOPaQ79kvXPi7/nlT01sb2M3H9fKr87Ni0TmZX84r5vKxh/XJj2Y+EtuZEG5Zdr5UzWLj2t37Lw2PJbNK//GUu5n645rcTdUdvqGTS+fn+7+oeaT45p1dU3PCWxu+XWPLvmrpuq41mn8A3sffGhW9keD/mjIvCc05a1vJi/pOi/73Qd7JrOsE9pkecUNNxUXZY+zn/mxpt8Jrc39NZ9Xz1hcvi8p++uacSe09zo1ffylmePLPfN7nKtZfEKrWjNsSXrxI+Vd26z4qmbtCa3jsrvnV+Y8Uj78zz4wfsTfJzc79mjZtzz1s8qqT2hx98xt9pI2v9y2rkci857Ubv/izpW9QW/449eNdpZ1Uksb03L+y+8vzJ7W4Akvu/mkljVt6lc7/p6b3bvN+QZs/Enty5cPXzs5sLj81vZ3ZbCSk1rS5C2z5cij5Td07deCrTupDdJqsi0XR5Xva/jaZzWfnNTeGl+SdKzrzPKpllvO1FSd1Mq+jq/sagtm3+PJ/bIm4ZT2blyjTtttd2ffseOlv2vantIaZDcuaChNKz/y3mOf1/Q7pa1uMWekt2Za+VO5zzRh409pXfvN2dujBuTwOo/8XrP4lPb71i2PT/m7MLvfTsv+mrWntA9anj3TrGZoeY97A/trPjml+U5ec2Z9zejyb5xDL9RUndLudbV5Qgk8VH7b5Le/rUk4rdULrl8+bPOC7O/u+OPnmrantZ8+zFpU9few8ibfR47U9DutTep1unykNrv8t3f7/1Qz7rR2uvK26rIZs7MPLV4J839a+3np74tssyZmr/Jd4WPrTmuW+LRhj14cWf5Uz+Vf1XxyWss/+VHG+zMezZ78wcWTNVWntb/nrn618/uPZre8sKoO8/6kTbj73TVLpk/KbvBbgodl/aR98dH4USWb52V/kDDtZE2/nzT333du6xh/Z/kPjxxpw8b/pHVP2Nz30+Ki8pdmHvGxkp+0e++9uHxxYUH5LDnvcM3an7QZQ3zbGhQtzO7ca3Rztvcn7bbXa954Rpqbfb6k+w81VT+BXnLrh/vZ2Ozlv768uyYB9NhRrdWcWUXlX22/9cuatme0YY70HZvZg9lVdbqdrel3Rrvl5eXr1tTkZyfeN/94zTjQu9+ven3ir3eUe2qeSWQlZzRpu+u+RcWzy7vXfe6bGtDj31avO2RjU7NLi5LqM9Cbl957++AL8s3lH4AmzqrPaIk/Xj2we87D5fKiB87XJFRp1iVVndv92a/8o/k/NGRZVdqAxIlnX3lofvbyq2aerwG98bqPPjsY0OZn59344l8146q0SVNXZJyT7y8PfPD7tzWLQU88NuXcvulTsmd8VwnzX6W1KytcVU8aV/7M91MyGOhpr7+y54YzD03Ibre18reaqirt7kfGSx2tY8vHDs49V5NQrX0Rl9Hn1Rnzy+98YM4vNW2rtco3/to6quiJ8rqevy7W9KvW7lm+86q/I09kz+y7W2Hjq7Wdt39fMYvNzD6+8yzgX7VWf1LH97+pGVOe+4VbYuuqtVNNf3ytSFtS3unAsxLbW639trr3tD+mF2dfvPjFHzVV1VpF3qfjrZYp5Y9ffM/FvD9r97vGzD5Y/Gj2wHM//FHT9metqsPFYX9Ens7+fNUhoL8/a6/dnDR+CluVvWqAD+jfz9qZr787+vvFRdlN+zf7q2bxz9rE/GuOZLEl2XdlX5vE1v2szZWU4mlFK7PXP9P8Qs0nP2sjFq5++crfc8vZwfnnaqp+1k7d88LTkaJl2c/OWeBm3rOa/56LS/KKV2cr1z0M9P+s1j6y+tSWmmXZs38tr6npd1bLb9NmxjFpcvbnvubna8ad1Ya4iyZv/KsoO7vLshRWclZrGZCzd8j55clDB6SwdWc1udHZ9jOLl5Zfc+vfp2o+OaudPdKv04yaueWPv7rBxarPatsCWTffUvNw+dqjD/xZk/CL9nTmfXMnsIfKiwa9Auv/Fy11/XptYM2S8ttHPO9mN/+ibZq5wD+z6LFs329/JrLxv2i7Dnk+eI8VZ7/b9i6A/y/aLS+80fppbXl5t/1fWdi6X7RvO00en1f0cPYdH79xvuaTX7R2SRFvF/mB7LS31sH6+0Vbd+vrw8cUrcg+t/bKVOY9pzV5uN6gjhdGZDdf0Avo/zntuluO5P8ozcoe+tZjx2r6ndPunvfGhlE187IrJ1kA/89p/c9uefL1isfKj20eV1Wz+JyW36LLWWfOk9mWF97/oWbtOa3HdE9kfc3y8q+beeuyvee0a4NHJgyrWFl+tGt1Aqs+p2Xc9rBrXtET2ftuOJLEvOe1Ds8On5BrGZz9QDNrHZZ1XnNe2XjPnsjj5TeO//J0Tb/z2melVmu+PK/8xf6DqmrGndeShn0c/2Pkyewk7491Wcl5raRq7UPbZszNXtr1Y4WtO69VuCNxjsDq8vJ6fRqwvee15r2u+LPFQyvK5z2w4VhN1XnNMuqn4vUzlpfXtkfodobBZGf4IWIT/kc3Dbhr5cqVJ7QHnm1Oz0/06P3kPX3ORrZqTRe0ZNV8XyP0a3R/Y/u7Z2e2+jRSfHvHzCZv/ZHN/ZtM5Y47I5v2HYqov1UedjyXsYmHIJjK7+xRd8rkQ5ExN79z6Nn7G/PyHFP5hdaPvFr/UOTQiHXPfD/7x3IeRmYqnzrlsUHvH4xUdm2+bFS6hb/PTOWDM7YsGHIwsmv2jb3bHk7m4648Hy1fM2dOluVgpItr5k+/dDvC+19hKu89asCNzx+IDF5+y5wPX1f5+yFTefGKVV/1OhBZWrztYN+7ruDlxaZy9dv3jh7fHznccv3Khg825eWDTeVzv06+e97+iLbuk3dSdqT+t/IcU/nUT/4MNN8fmfzFbZlN7q7Dx6+ayleM2rxi+76Ipf+xkeVrGwn4mMf/8sv3jtgXqV4zs/2HjRoJ+Jwzjf+13xdY90WG3229+MGapvz9ClN5ycSjTcr2RuKVczPO5Ll5echUvvet5Vfk7I0UtT73zIYO1eX/qbzYVJ5z35i0dz+JPJK98uUWd3gEfEzlg4/sfLV6T6TJ2jlPrW/aUsDHVF7dYqy92Z6It0br369tXQEfU3lFvzzfvbsj6SN3bFzynk+sC1N5aNVHvy3eFblq9uqR/aY1+2/llb+Y4NO6YM6WnZHF6xe0W3dTPV5eYSqvKL7p4192RIaX7NaG3vQex7+QqXzd0UbljXdETm7ueWTYwis2/afyYlP5zeeeuvvWjyPfHdxs+XxfC7H+TOV71dxQ0faI848viyKbdPiZyiu98ryXP4rcef1t+SVf/sdy1dx+vWMJn34YGX70jbLg916Bf2b4vDA+q2ZbpPPN3tXXPdPwv5VXnjWNv/S7H5puiyy+x16y4GtV4KepvHjn6JZ9P4hkT716yGZ33Wv/U3nIVF7SUP1rwtZIl/7N+s6Z+rOgb6by6kYXbn1sS8TxwYS6WYuaCPiayge3PdRi/ebI42WJac8Wt/lv5Tnm7+8tnPFZReTcPcfnPj4q7tr/VK6ayiu/bLfkdCRytn3Zvf0nCfxgpnLWEtbH+5FsWCitrmpx7X8qr/zZhL/3LO5/X3nE9v6gO+9wNxDwN5VXXt9lzNL3Ittfuuf41Z0Fffxf5SFTeajdpz22boiMvL1t3+aFyf+tvNhUPviH+fur34l8MbH9xx2fEPRrsKlctWn29Lcjd9z34ZB7ZEH//ld5jrn/6Y9/Fngz8k3y77u+uK/VfytXTeXFZWc65L4ecZYtnnxfYYqAv7k8sSIrbm1kyaMdZj1zV+v/Vl5ZbSqvN+Grbi9Hbhz/6Q8PzMz4b+UVpvKKK3+9s+CFyJnSs1f1/KvVpv9UHjKX//3uI8+URV76u+n59fL57P9UXmwqZ1Pjn5y5OvK9c0Zh0+Lmm/5T+WDz+A7Z0999ItL5+T+W9V+UKdaX+f2/1q2pWBx56vkDvxY2/Kb8P5Wr5nJvXovKosj3OV94tKP1Nv2nclb9D37eUX+Rfy2uqDKVz5uU6i3Wjrd8emXeR4K+FpvKi5fdebtaou3/7ajtniO6fGV+/+PMK/qs0K5y333leyHBH5ipPOfYvIGBkHbbZz/fW5EoCfw4Y3q/zcHXhj+rZV7cNGliHTH/xabyitUpLy1fo01vevfex6aJ8eeYy7/aPXHnK5o983CvsyPrC/iZy20V7U6+pj14zcf9uibGC/r/k2l999x3zROva08+47l94JU6fzSVV+574fymN7XPbvryufu2i/U32FQeeqLv3Sfe1ho2GJhtGyX6n2MqrzgZd4Ct16786ekXFzU8zfGTmcpz7hp4X/t3tS96bepyb2JjAZ/Tpv69umh7cKP2w8jfWhaXJIv+mcpzyqU755ZrB165+8N9PXX50FSuxs3q/NH7WmWPH9eOrGgt+nfaTN87Lzke0S7Glfb79CqdvpvLm818tO5m7ay99Z6pVUK+qTxl4l+NZ7R8abN21cpO3R99QcAnZCovnuMesm+LVvrWQztHP60I+moqL0ld91fuVm1e/g2N17T9kMMnx1S+rv2sa5d8oE1952L/abMEfVfN5aXf/9Bsm/bR9FE/HG8vxl95MlruXfj+TXd8qE1tk91qwSe6/GQqHz9pQVL1h9q3vqd+WJSoz7+p/ObuDy+a95FmvW7JeO9wXf8wlbPOp9a+v13b1+rES/2vtQv4mst/O3L33R9r42pCd2aetQv6ayqvnJ/907Id2ijf7Tdfly/oS+UJk/xzzx2H2+3UXvr2lZsWXS3k4wpTeeU1nR7Zu1N7J6n/XR/cIOY3ZCr3Vn/457hd2v6Wj2/LP/0zpz+DTeUlB9dd+/pu7ep1qb+1qBHrN8f8/rGa+Nv2aFnnAoObJW3h86OaytlX3796fo+W+OjG3FTfDt4+M5Wve3N0xspPtKxv3DtO70wX8D9u0t/6Du40Ya+25Kaf6nz51AVB303lg4eMaP3BXu3Eyew6C9KEfFxsKj+O+LlPy6h+bmi8T6y/wabyC6/svDdvn/ZQned+271Klz9N5SPvHroysk9bv6nXLT89r/NXU/mG+DE9UvZrJ9/r+d7Xjwj5qPKYCX5HCqvf36+ds9x8/R9PCfmmwlQ++MC3P6cc0DZk+w48cFTMb8hU7n1/8oi8A9r2KT+v2z02UYzPVJ7VfsqtWw5o926yvdP/mjSxvk3lxw81fqveQe3pypLTHb53iPGZyrdP2LJowkFt0qcjnHuatRX00dx+3WcqPz6oPXs4Ln2eKuRHZioPdbK/5j+k3fXRsIfGvy/0/sofTfi5/bbfHjykVeUMPPPTq0K+qTCVD77rm02HDmlHcp91tHDFbfr/AIzWo4SEPQEA';
