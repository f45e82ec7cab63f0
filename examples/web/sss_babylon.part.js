// Separable subsurface scattering for Babylon.js, by ms_sss.h, in place of the engine's own pass: its prepass draws light, depth and
// color of materials that scatter; two passes of ms_sss.glsl then do what subSurfaceScattering.fragment.fx does, and write where it does.
// `make web` writes this file: examples/web/sss_babylon.part.js and sss_core.part.js, examples/engine/shader/ms_sss.glsl (SHADER), and the header
// in WebAssembly (BINARY).
//
//   <script src="babylon.js"></script> <script src="sss_babylon.js"></script>        or import 'sss_babylon.js' beside @babylonjs/core
//   const sss = await BabylonSubsurface.create(BABYLON, scene, [
//     { reflectance: [0.44, 0.22, 0.13], path: [1.8, 1.2, 0.73] },    a material's diffuse reflectance and mean free
//     { reflectance: [0.83, 0.79, 0.75], path: [0.41, 0.66, 1.03] }], path in mm, red, green, blue; at most 5, as Babylon has
//     { mmPerUnit: 40, radius: 60 });                               the widest kernel on the screen, in pixels
//   sss.apply(head.material, 0);                    a PBRMaterial, and which of them it is
//   sss.enabled = false;                            Babylon's own pass, with the same profiles
//
// Lights, shadows, specular light, image processing and post-processes are Babylon's. WebGL 2.
globalThis.BabylonSubsurface = class BabylonSubsurface {
  // options: mmPerUnit (1000: meters), radius (pixels that the taps are made for), taps (odd, 3 to 63; 7 serve up to some 20 pixels, or 0: as
  // few as show no bands at that radius, by the table of ms_sss_shader_constants)
  static async create(BABYLON, scene, materials, { mmPerUnit = 1000, radius = 40, taps = 0 } = {}) {
    if (!BABYLON || !scene.getEngine()._gl || scene.getEngine().webGLVersion < 2) throw new Error('BabylonSubsurface: wants Babylon.js with WebGL 2');
    if (!materials.length || materials.length > 5) throw new Error('BabylonSubsurface: wants one to five materials');
    return new BabylonSubsurface(BABYLON, scene, await BabylonSubsurface.core(), materials, mmPerUnit, taps || Kernels.tapsOf(radius), radius);
  }

  static core() { return Kernels.load('BabylonSubsurface'); }

  // The text of a pass, 0 or 1, for textures as Babylon's prepass leaves them: light with the profile's index in alpha, 255 where there is
  // none, and the depth of the view. The second one adds the result, times the albedo, to what does not scatter.
  static text(pass, taps, materials) {
    return `#version 300 es
precision highp float;
precision highp int;
precision highp sampler2D;
#define MS_SSS_STEP ${pass}
#define MS_SSS_TAPS ${taps}
#define MS_SSS_PROFILES ${materials}
#define ms_sss_input textureSampler
uniform sampler2D irradianceSampler, depthSampler, albedoSampler, colorSampler;
int index_of(ivec2 p) { return int(round(texelFetch(irradianceSampler, p, 0).a * 255.0)); }
vec3 ms_sss_fetch_color(ivec2 p) { return texelFetch(irradianceSampler, p, 0).rgb; }
float ms_sss_fetch_depth(ivec2 p) { return texelFetch(depthSampler, p, 0).r; }
int ms_sss_fetch_profile(ivec2 p) { return index_of(p); }
${pass ? '#define main scatter' : ''}
${SHADER}
${pass ? `#undef main
void main() {
  ivec2 p = ivec2(gl_FragCoord.xy);
  vec4 color = texelFetch(colorSampler, p, 0);
  scatter();
  ms_sss_out = index_of(p) < ${materials} ? vec4(color.rgb + texelFetch(albedoSampler, p, 0).rgb * ms_sss_out.rgb, 1.0) : color;
}` : ''}`;
  }

  constructor(BABYLON, scene, kernels, materials, mmPerUnit, taps, radius) {
    Object.assign(this, { BABYLON, scene, kernels, mmPerUnit, taps, radius, count: materials.length, ours: true });
    this.materials = materials.map((material, i) => kernels.make(i, material, taps, radius));
    const config = this.config = scene.enableSubSurfaceForPrePass();
    if (!config) throw new Error('BabylonSubsurface: this engine has no prepass');
    config.metersPerUnit = mmPerUnit / 1000;
    config.clearAllDiffusionProfiles();
    for (const { d } of this.materials) { // Burley's profile of the same distances: S = 1 / d, and the widest one is sampled
      const widest = Math.max(...d);
      config.ssDiffusionS.push(...d.map(v => 1 / v));
      config.ssDiffusionD.push(widest);
      config.ssFilterRadii.push(config._sampleBurleyDiffusionProfile(0.997, widest));
      config.ssDiffusionProfileColors.push(new BABYLON.Color3(...d.map(v => 1 / v)));
    }
    this.passes = [0, 1].map(pass => this.pass(pass));
    const self = this;
    this.passes.forEach((postProcess, pass) => scene.prePassRenderer.addEffectConfiguration({
      name: 'ms_sss' + pass, texturesRequired: config.texturesRequired, needsImageProcessing: true, postProcess,
      get enabled() { return self.ours && config.enabled; }, set enabled(yes) { /* follows Babylon's own */ },
    }));
    this.enabled = true;
  }

  pass(pass) {
    const { BABYLON, scene } = this, name = `ms_sss${pass}_${this.taps}_${this.count}`;
    BABYLON.Effect.ShadersStore[name + 'FragmentShader'] = BabylonSubsurface.text(pass, this.taps, this.count);
    const p = new BABYLON.PostProcess(name, name, ['ms_sss'], ['irradianceSampler', 'depthSampler', 'albedoSampler', 'colorSampler'], 1, null,
      BABYLON.Texture.NEAREST_SAMPLINGMODE, scene.getEngine(), false, null, BABYLON.Constants.TEXTURETYPE_FLOAT);
    p.autoClear = false;
    p.onApplyObservable.add(effect => {
      const renderer = scene.prePassRenderer, { textures } = renderer.getRenderTarget(), of = type => textures[renderer.getIndex(type)];
      const { width, height } = of(0).getSize();
      effect.setTexture('irradianceSampler', of(0));
      effect.setTexture('depthSampler', of(5));
      if (pass) {
        effect.setTexture('albedoSampler', of(7));
        effect.setTexture('colorSampler', of(4));
      }
      effect.setArray4('ms_sss', this.kernels.constants(this.taps, this.count, width, height, scene.activeCamera.fov * 180 / Math.PI, this.mmPerUnit));
    });
    return p;
  }

  get enabled() { return this.ours; }
  set enabled(yes) { // one of two post-processes: Babylon's, or these
    const { config } = this;
    this.ours = yes;
    if (yes) {
      this.theirs = config.postProcess || this.theirs;
      config.postProcess = null;
      config.createPostProcess = () => null;
    } else {
      delete config.createPostProcess;
      config.postProcess = this.theirs || config.createPostProcess();
    }
    this.scene.prePassRenderer.markAsDirty();
  }

  apply(material, index) {
    if (!this.materials[index] || material.getClassName() !== 'PBRMaterial') throw new Error(`BabylonSubsurface: wants a PBRMaterial and an index below ${this.count}`);
    material.subSurface.isScatteringEnabled = true;
    material.subSurface.scatteringDiffusionProfile = this.config.ssDiffusionProfileColors[index];
  }

  dispose() {
    this.enabled = false;
    for (const p of this.passes) p.dispose();
  }
};
