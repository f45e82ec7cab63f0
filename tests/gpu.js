// Runs the page that a program wrote with tests/gpu.h: the steps of each case in WebGL 2 or WebGPU, and compares the last image with
// the CPU's result. data = {compile: texts that only have to compile, images: {name: {size, pixels}} of all cases, cases: [{api,
// tolerance, images, expected, steps: [{text, constants, size, groups of a compute shader, read: {sampler: image}, write: [image]}]}]},
// pixels in base64, of RGBA floats; NaN in expected: anything. Logs what is off or an error, then "gpu worst E in NAME over N cases gpu".
const floats = text => new Float32Array(Uint8Array.from(atob(text), c => c.charCodeAt(0)).buffer);
const open = {
    webgl() {
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
        gl.bindFramebuffer(gl.FRAMEBUFFER, gl.createFramebuffer());
        const attach = images => {
            for (let i = 0; i < 2; ++i) gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0 + i, gl.TEXTURE_2D, images[i] ? images[i].texture : null, 0);
            gl.drawBuffers(images.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
        };
        return {
            name: gl.getParameter(gl.VERSION),
            async compile(text) { stage(gl.FRAGMENT_SHADER, text); },
            image(size, pixels) {
                const texture = gl.createTexture();
                gl.bindTexture(gl.TEXTURE_2D, texture);
                gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, ...size, 0, gl.RGBA, gl.FLOAT, pixels);
                gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
                gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
                return {texture, size};
            },
            run(step, read, write) {
                const p = gl.createProgram();
                gl.attachShader(p, stage(gl.VERTEX_SHADER, corner));
                gl.attachShader(p, stage(gl.FRAGMENT_SHADER, step.text));
                gl.linkProgram(p);
                if (!gl.getProgramParameter(p, gl.LINK_STATUS)) throw gl.getProgramInfoLog(p);
                gl.useProgram(p);
                Object.keys(step.read).forEach((name, i) => {
                    gl.activeTexture(gl.TEXTURE0 + i);
                    gl.bindTexture(gl.TEXTURE_2D, read(name).texture);
                    gl.uniform1i(gl.getUniformLocation(p, name), i);
                });
                gl.uniform4fv(gl.getUniformLocation(p, step.block), step.constants);
                attach(write);
                gl.viewport(0, 0, ...step.size);
                gl.drawArrays(gl.TRIANGLES, 0, 3);
                if (gl.getError()) throw 'an error of OpenGL';
            },
            async pixels(image) {
                const out = new Float32Array(image.size[0] * image.size[1] * 4);
                attach([image]);
                gl.readPixels(0, 0, ...image.size, gl.RGBA, gl.FLOAT, out);
                return out;
            }
        };
    },
    async webgpu() {
        const adapter = navigator.gpu && await navigator.gpu.requestAdapter();
        if (!adapter) return null;
        const device = await adapter.requestDevice();
        device.addEventListener('uncapturederror', e => console.log('error: ' + e.error.message));
        const corner = device.createShaderModule({code: `@vertex fn main(@builtin(vertex_index) i: u32) -> @builtin(position) vec4<f32> {
            return vec4<f32>(select(-1.0, 3.0, i == 1u), select(-1.0, 3.0, i == 2u), 0.0, 1.0); }`});
        return {
            name: 'WebGPU, ' + adapter.info.vendor + ' ' + adapter.info.architecture,
            async compile(text) { await device.createShaderModule({code: text}).getCompilationInfo(); }, // errors come as an uncapturederror
            image(size, pixels) {
                const texture = device.createTexture({size, format: 'rgba32float', usage: GPUTextureUsage.TEXTURE_BINDING | GPUTextureUsage.COPY_DST |
                    GPUTextureUsage.COPY_SRC | GPUTextureUsage.RENDER_ATTACHMENT | GPUTextureUsage.STORAGE_BINDING});
                if (pixels) device.queue.writeTexture({texture}, pixels, {bytesPerRow: size[0] * 16}, size);
                return {texture, size};
            },
            run(step, read, write) {
                const module = device.createShaderModule({code: step.text});
                const compute = step.groups !== undefined, visibility = compute ? GPUShaderStage.COMPUTE : GPUShaderStage.FRAGMENT;
                const buffer = device.createBuffer({size: step.constants.length * 4, usage: GPUBufferUsage.UNIFORM | GPUBufferUsage.COPY_DST});
                device.queue.writeBuffer(buffer, 0, new Float32Array(step.constants));
                const layout = [{binding: 0, visibility, buffer: {}}], entries = [{binding: 0, resource: {buffer}}];
                for (const [, binding, name, store] of step.text.matchAll(/@binding\((\d+)\) var (\w+): texture_(storage)?/g)) {
                    layout.push(store ? {binding: +binding, visibility, storageTexture: {format: 'rgba32float'}} : {binding: +binding, visibility, texture: {sampleType: 'unfilterable-float'}});
                    entries.push({binding: +binding, resource: (store ? write[0] : read(name)).texture.createView()});
                }
                const group = device.createBindGroupLayout({entries: layout}), all = device.createPipelineLayout({bindGroupLayouts: [group]});
                const commands = device.createCommandEncoder();
                const pass = compute ? commands.beginComputePass() : commands.beginRenderPass({colorAttachments: write.map(t => ({view: t.texture.createView(), loadOp: 'clear', storeOp: 'store'}))});
                pass.setPipeline(compute ? device.createComputePipeline({layout: all, compute: {module, entryPoint: 'main'}})
                    : device.createRenderPipeline({layout: all, vertex: {module: corner, entryPoint: 'main'}, fragment: {module, entryPoint: 'main', targets: write.map(() => ({format: 'rgba32float'}))}}));
                pass.setBindGroup(0, device.createBindGroup({layout: group, entries}));
                if (compute) pass.dispatchWorkgroups(...step.groups);
                else pass.draw(3);
                pass.end();
                device.queue.submit([commands.finish()]);
            },
            async pixels({texture, size: [width, height]}) {
                const pitch = Math.ceil(width / 16) * 256;
                const buffer = device.createBuffer({size: pitch * height, usage: GPUBufferUsage.COPY_DST | GPUBufferUsage.MAP_READ});
                const commands = device.createCommandEncoder();
                commands.copyTextureToBuffer({texture}, {buffer, bytesPerRow: pitch}, [width, height]);
                device.queue.submit([commands.finish()]);
                await buffer.mapAsync(GPUMapMode.READ);
                const rows = new Float32Array(buffer.getMappedRange()), out = new Float32Array(width * height * 4);
                for (let y = 0; y < height; ++y) out.set(rows.subarray(y * pitch / 4, y * pitch / 4 + width * 4), y * width * 4);
                return out;
            }
        };
    }
};

(async () => {
    const gpus = {};
    for (const [i, c] of data.cases.entries()) try {
        if (!gpus[c.api]) {
            const gpu = gpus[c.api] = {worst: 0, count: 0, targets: {}, shared: {}, on: await open[c.api]()};
            for (const text of gpu.on ? data.compile : []) await gpu.on.compile(text);
            for (const [name, {size, pixels}] of gpu.on ? Object.entries(data.images) : []) gpu.shared[name] = gpu.on.image(size, floats(pixels));
        }
        const {on, targets, shared} = gpus[c.api], images = {...shared};
        if (!on) continue;
        for (const [name, {size, pixels}] of Object.entries(c.images)) images[name] = on.image(size, floats(pixels));
        let out;
        for (const step of c.steps) {
            const write = step.write.map(name => images[name] = targets[name + step.size] ??= on.image(step.size, null));
            on.run(step, name => images[step.read[name]] ?? Object.values(images)[0], write); // of a step's reads the text may not use all
            out = write[0];
        }
        const got = await on.pixels(out), want = floats(c.expected);
        let error = 0;
        want.forEach((v, k) => { if (v === v && !(Math.abs(v - got[k]) <= error)) error = v === got[k] ? error : Math.abs(v - got[k]) || 1e9; });
        if (!(error <= c.tolerance)) console.log(`case ${i} in ${c.api} off by ${error}`);
        gpus[c.api].worst = Math.max(gpus[c.api].worst, error);
        ++gpus[c.api].count;
    } catch (e) {
        console.log(`error: case ${i} in ${c.api}: ${e}`);
    }
    console.log('gpu worst ' + Object.entries(gpus).map(([api, g]) => g.on ? `${g.worst.toExponential(1)} over ${g.count} cases in ${g.on.name}` : 'no ' + api).join(', ') + ' gpu');
})();
