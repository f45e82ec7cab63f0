// Runs what tests/pkg_nn_gpu.c wrote: cases = [{api, tolerance, rows, inputs: [width, height], weights, values, expected: base64 of RGBA
// floats, steps: [{width, height, constants, text}]}], each through its steps in WebGL 2 or WebGPU, and compares the last target
// (NaN: anything). Logs what is off or an error, then "nn worst E in WebGL 2, E in WebGPU nn"; an API that is not there is named.
const WIDTH = 2048;
const floats = text => new Float32Array(Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer);

function webgl() {
    const gl = document.createElement('canvas').getContext('webgl2');
    if (!gl || !gl.getExtension('EXT_color_buffer_float')) return null;
    const corner = '#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }';
    const stage = (type, text) => {
        const s = gl.createShader(type);
        gl.shaderSource(s, text);
        gl.compileShader(s);
        if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw gl.getShaderInfoLog(s);
        return s;
    };
    const texture = (width, height, pixels) => {
        const t = gl.createTexture();
        gl.bindTexture(gl.TEXTURE_2D, t);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, pixels);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
        return t;
    };
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    return {
        texture,
        draw(step, weights, values, target) {
            const p = gl.createProgram();
            gl.attachShader(p, stage(gl.VERTEX_SHADER, corner));
            gl.attachShader(p, stage(gl.FRAGMENT_SHADER, step.text));
            gl.linkProgram(p);
            if (!gl.getProgramParameter(p, gl.LINK_STATUS)) throw gl.getProgramInfoLog(p);
            gl.useProgram(p);
            [['ms_nn_weights', weights], ['ms_nn_values', values]].forEach(([name, t], i) => {
                gl.activeTexture(gl.TEXTURE0 + i);
                gl.bindTexture(gl.TEXTURE_2D, t);
                gl.uniform1i(gl.getUniformLocation(p, name), i);
            });
            gl.uniform4fv(gl.getUniformLocation(p, 'ms_nn'), step.constants);
            gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, target, 0);
            gl.viewport(0, 0, step.width, step.height);
            gl.drawArrays(gl.TRIANGLES, 0, 3);
            if (gl.getError()) throw 'an error of OpenGL';
        },
        async pixels(target, width, height) {
            const out = new Float32Array(4 * width * height);
            gl.readPixels(0, 0, width, height, gl.RGBA, gl.FLOAT, out);
            return out;
        }
    };
}

async function webgpu() {
    const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
    if (!adapter) return null;
    const device = await adapter.requestDevice();
    device.addEventListener('uncapturederror', e => console.log('error: ' + e.error.message));
    const corner = device.createShaderModule({code: `@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
        return vec4<f32>(select(-1.0, 3.0, i == 1u), select(-1.0, 3.0, i == 2u), 0.0, 1.0); }`});
    return {
        texture(width, height, pixels) {
            const t = device.createTexture({size: [width, height], format: 'rgba32float',
                usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST | GPUTextureUsage.COPY_SRC | GPUTextureUsage.RENDER_ATTACHMENT});
            if (pixels) device.queue.writeTexture({texture: t}, pixels, {bytesPerRow: width * 16}, [width, height]);
            return t;
        },
        draw(step, weights, values, target) {
            const pipeline = device.createRenderPipeline({layout: 'auto', vertex: {module: corner, entryPoint: 'main'},
                fragment: {module: device.createShaderModule({code: step.text}), entryPoint: 'main', targets: [{format: 'rgba32float'}]}});
            const entries = [{binding: 1, resource: weights.createView()}, {binding: 2, resource: values.createView()}];
            if (step.text.includes('var<uniform>')) {
                const b = device.createBuffer({size: 16, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
                device.queue.writeBuffer(b, 0, new Float32Array(step.constants));
                entries.push({binding: 0, resource: {buffer: b}});
            }
            const encoder = device.createCommandEncoder();
            const pass = encoder.beginRenderPass({colorAttachments: [{view: target.createView(), loadOp: 'clear', storeOp: 'store'}]});
            pass.setPipeline(pipeline);
            pass.setBindGroup(0, device.createBindGroup({layout: pipeline.getBindGroupLayout(0), entries}));
            pass.draw(3);
            pass.end();
            device.queue.submit([encoder.finish()]);
        },
        async pixels(target, width, height) {
            const pitch = Math.ceil(width / 16) * 256;
            const b = device.createBuffer({size: pitch * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
            const encoder = device.createCommandEncoder();
            encoder.copyTextureToBuffer({texture: target}, {buffer: b, bytesPerRow: pitch}, [width, height]);
            device.queue.submit([encoder.finish()]);
            await b.mapAsync(GPUMapMode.READ);
            const all = new Float32Array(b.getMappedRange()), out = new Float32Array(4 * width * height);
            for (let y = 0; y < height; ++y) out.set(all.subarray(y * pitch / 4, y * pitch / 4 + 4 * width), y * 4 * width);
            return out;
        }
    };
}

(async () => {
    const apis = {webgl: webgl(), webgpu: await webgpu().catch(() => null)}, worst = {webgl: -1, webgpu: -1};
    for (const [i, c] of cases.entries()) {
        const api = apis[c.api];
        if (!api) continue;
        try {
            const weights = api.texture(WIDTH, c.rows, floats(c.weights)), last = c.steps[c.steps.length - 1];
            let values = api.texture(...c.inputs, floats(c.values));
            for (const step of c.steps) {
                const target = api.texture(step.width, step.height, null);
                api.draw(step, weights, values, target);
                values = target;
            }
            const got = await api.pixels(values, last.width, last.height), want = floats(c.expected);
            let e = 0;
            want.forEach((v, k) => { if (v === v && !(Math.abs(v - got[k]) <= e)) e = Math.abs(v - got[k]); });
            if (!(e <= c.tolerance)) console.log(`case ${i} in ${c.api} off by ${e}`);
            worst[c.api] = Math.max(worst[c.api], e);
        } catch (e) {
            console.log(`error: case ${i} in ${c.api}: ${e}`);
        }
    }
    const name = (k, n) => worst[k] < 0 ? 'no ' + n : worst[k].toExponential(1) + ' in ' + n;
    console.log(`nn worst ${name('webgl', 'WebGL 2')}, ${name('webgpu', 'WebGPU')} nn`);
})();
