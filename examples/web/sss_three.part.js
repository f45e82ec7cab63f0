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
