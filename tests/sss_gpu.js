// Runs what tests/pkg_sss_gpu.c wrote: the steps of each case in WebGL 2 or WebGPU, and compares with the CPU's result (NaN: with none).
// data = {api, width, height, targets: {name: [width, height]}, images: {name: base64 of RGBA floats}, cases: [{input, profile, expected, tolerance, steps: [{text,
// constants, read: {name: image}, write: [image], groups}]}], compile: texts that only have to compile}. Logs what is off or an error, then "sss worst E over N cases".
const count = data.width * data.height * 4;
const lines = [];
const say = line => lines.push(line);
const floats = text => new Float32Array(Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer);

// WebGL 2: {image, run, pixels}
function webgl() {
    const gl = document.createElement('canvas').getContext('webgl2');
    if (!gl || !gl.getExtension('EXT_color_buffer_float')) throw 'no WebGL 2 with float targets';
    const corner = '#version 300 es\nvoid main() { gl_Position = vec4(gl_VertexID == 1 ? 3 : -1, gl_VertexID == 2 ? 3 : -1, 0, 1); }';
    const stage = (type, text) => {
        const s = gl.createShader(type);
        gl.shaderSource(s, text);
        gl.compileShader(s);
        if (!gl.getShaderParameter(s, gl.COMPILE_STATUS)) throw gl.getShaderInfoLog(s);
        return s;
    };
    gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
    const attach = images => {
        for (let i = 0; i < 2; ++i) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, images[i] ? images[i].texture : null, 0);
        gl.drawBuffers(images.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
    };
    return {
        name: () => gl.getParameter(gl.VERSION),
        async compile(text) { stage(gl.FRAGMENT_SHADER, text); },
        image(pixels, width, height) {
            const texture = gl.createTexture();
            gl.bindTexture(gl.TEXTURE_2D, texture);
            gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, width, height, 0, gl.RGBA, gl.FLOAT, pixels);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
            gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
            return {texture, width, height};
        },
        run(step, read, write) {
            const p = gl.createProgram();
            gl.attachShader(p, stage(gl.VERTEX_SHADER, corner));
            gl.attachShader(p, stage(gl.FRAGMENT_SHADER, step.text));
            gl.linkProgram(p);
            if (!gl.getProgramParameter(p, gl.LINK_STATUS)) throw gl.getProgramInfoLog(p);
            gl.useProgram(p);
            read.forEach((r, i) => {
                gl.activeTexture(gl.TEXTURE0 + i);
                gl.bindTexture(gl.TEXTURE_2D, r.image.texture);
                gl.uniform1i(gl.getUniformLocation(p, r.name), i);
            });
            gl.uniform4fv(gl.getUniformLocation(p, 'ms_sss'), step.constants);
            attach(write);
            gl.viewport(0, 0, write[0].width, write[0].height);
            gl.drawArrays(gl.TRIANGLES, 0, 3);
            if (gl.getError()) throw 'an error of OpenGL';
        },
        async pixels(image) {
            const out = new Float32Array(count);
            attach([image]);
            gl.readPixels(0, 0, data.width, data.height, gl.RGBA, gl.FLOAT, out);
            return out;
        }
    };
}

async function webgpu() {
    const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
    if (!adapter) throw 'no WebGPU';
    const device = await adapter.requestDevice();
    device.addEventListener('uncapturederror', e => say('error: ' + e.error.message));
    const pitch = Math.ceil(data.width * 16 / 256) * 256;
    const corner = device.createShaderModule({code: `@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
        return vec4<f32>(select(-1.0, 3.0, i == 1u), select(-1.0, 3.0, i == 2u), 0.0, 1.0); }`});
    return {
        name: () => 'WebGPU, ' + adapter.info.vendor + ' ' + adapter.info.architecture,
        async compile(text) { // errors come as an uncapturederror
            await device.createShaderModule({code: text}).getCompilationInfo();
        },
        image(pixels, width, height) {
            const t = device.createTexture({size: [width, height], format: 'rgba32float',
                usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST | GPUTextureUsage.COPY_SRC | GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.STORAGE_BINDING});
            if (pixels) device.queue.writeTexture({texture: t}, pixels, {bytesPerRow: data.width * 16}, [data.width, data.height]);
            return t;
        },
        run(step, read, write) {
            const module = device.createShaderModule({code: step.text});
            const compute = step.groups !== undefined, stage = compute ? GPUShaderStage.COMPUTE : GPUShaderStage.FRAGMENT;
            const constants = device.createBuffer({size: step.constants.length * 4, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
            device.queue.writeBuffer(constants, 0, new Float32Array(step.constants));
            const layout = [{binding: 0, visibility: stage, buffer: {}}], entries = [{binding: 0, resource: {buffer: constants}}];
            for (const [, binding, name] of step.text.matchAll(/@binding\((\d+)\) var (ms_sss_\w+): /g)) {
                const target = name === 'ms_sss_target', image = target ? write[0] : read.find(r => r.name === name).image;
                layout.push(target ? {binding: +binding, visibility: stage, storageTexture: {format: 'rgba32float'}}
                                    : {binding: +binding, visibility: stage, texture: {sampleType: 'unfilterable-float'}});
                entries.push({binding: +binding, resource: image.createView()});
            }
            const group = device.createBindGroupLayout({entries: layout}), all = device.createPipelineLayout({bindGroupLayouts: [group]});
            const commands = device.createCommandEncoder();
            let pass;
            if (compute) {
                pass = commands.beginComputePass();
                pass.setPipeline(device.createComputePipeline({layout: all, compute: {module, entryPoint: 'main'}}));
            } else {
                pass = commands.beginRenderPass({colorAttachments: write.map(t => ({view: t.createView(), loadOp: 'clear', storeOp: 'store'}))});
                pass.setPipeline(device.createRenderPipeline({layout: all, vertex: {module: corner, entryPoint: 'main'},
                    fragment: {module, entryPoint: 'main', targets: write.map(() => ({format: 'rgba32float'}))}, primitive: {topology: 'triangle-list'}}));
            }
            pass.setBindGroup(0, device.createBindGroup({layout: group, entries}));
            if (compute) pass.dispatchWorkgroups(...step.groups);
            else pass.draw(3);
            pass.end();
            device.queue.submit([commands.finish()]);
        },
        async pixels(image) {
            const buffer = device.createBuffer({size: pitch * data.height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
            const commands = device.createCommandEncoder();
            commands.copyTextureToBuffer({texture: image}, {buffer, bytesPerRow: pitch}, [data.width, data.height]);
            device.queue.submit([commands.finish()]);
            await buffer.mapAsync(GPUMapMode.READ);
            const rows = new Float32Array(buffer.getMappedRange()), out = new Float32Array(count);
            for (let y = 0; y < data.height; ++y) out.set(rows.subarray(y * pitch / 4, y * pitch / 4 + data.width * 4), y * data.width * 4);
            return out;
        }
    };
}

(async () => {
    let worst = 0, done = 0, name = '';
    try {
        const gpu = data.api === 'webgpu' ? await webgpu() : webgl();
        name = gpu.name();
        for (const text of data.compile) await gpu.compile(text);
        const shared = {};
        for (const [key, text] of Object.entries(data.images)) shared[key] = gpu.image(floats(text), data.width, data.height);
        for (const [key, size] of Object.entries(data.targets)) shared[key] = gpu.image(null, ...size);
        for (const [i, c] of data.cases.entries()) {
            const input = floats(c.input), expected = floats(c.expected);
            const images = {...shared, input: gpu.image(input, data.width, data.height), profile: gpu.image(floats(c.profile), data.width, data.height)};
            let error = 0;
            for (const step of c.steps)
                gpu.run(step, Object.entries(step.read).map(([name, image]) => ({name, image: images[image]})), step.write.map(w => images[w]));
            const out = await gpu.pixels(images[c.steps[c.steps.length - 1].write[0]]);
            for (let k = 0; k < count; ++k) {
                if (k % 4 === 3 || !Number.isFinite(input[k]) || Number.isNaN(expected[k])) continue;
                const e = Math.abs(out[k] - expected[k]);
                if (!(e <= error)) error = e === e ? e : 1e9;
            }
            if (error > c.tolerance) say('case ' + i + ': off by ' + error);
            worst = Math.max(worst, error);
            ++done;
        }
    } catch (e) { say('error: ' + e); }
    console.log(lines.join('; ') + 'sss worst ' + worst.toExponential(1) + ' over ' + done + ' cases, ' + name + ' sss');
})();
