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

