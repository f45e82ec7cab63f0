/* MaterialX files as MaterialX's own library reads them (its WebAssembly build, in Node):

     node tests/materialx.mjs LIBRARY OUT FILE.mtlx...

   LIBRARY: the folder of JsMaterialXGenShader.js. Upgrades and validates each document, finds the node definition of every shader, checks
   each input against it, has the library write the shader in every language it knows, and leaves in OUT/FILE.json what it read. Ends with
   1 and a line for each thing that is wrong. */
import fs from "node:fs";
import path from "node:path";
import { createRequire } from "node:module";

const [folder, out, ...files] = process.argv.slice(2);
const script = folder + "/JsMaterialXGenShader.js";
// As a script: it asks for Node's own modules in the way of scripts, though it is packed as a module.
const MaterialX = new Function("require", "__filename", "__dirname", fs.readFileSync(script, "utf8").replace(/^export default .*$/m, "")
    + "; return MaterialX;")(createRequire(script), script, folder);
const mx = await MaterialX({ locateFile: name => folder + "/" + (name.endsWith(".data") ? name + ".txt" : name) });
const wrong = [];
const check = (true_, message) => { if (!true_) wrong.push(message); };

const languages = { essl: mx.EsslShaderGenerator, glsl: mx.GlslShaderGenerator, wgsl: mx.WgslShaderGenerator, msl: mx.MslShaderGenerator,
    osl: mx.OslShaderGenerator, mdl: mx.MdlShaderGenerator };
const essl = mx.EsslShaderGenerator.create(), library = mx.loadStandardLibraries(new mx.GenContext(essl));
async function open(text) {
    const d = mx.createDocument();
    d.setDataLibrary(library);
    await mx.readFromXmlString(d, text, "");
    return d;
}

const plain = value => {
    const data = value.getData();
    return typeof data === "number" ? [data] : [0, 1, 2].map(k => data.getItem(k));
};

async function look(file) {
    const text = fs.readFileSync(file, "utf8"), document = await open(text);
    const read = { version: mx.getVersionString(), materials: {} };
    let defaults = null;
    check(document.validate(), file + " is not valid");
    // the library sees what is wrong:
    check(!(await open(text.replace('name="metalness" type="float"', 'name="metalness" type="color3"'))).validate(), "an input of a wrong type is valid");
    check(!(await open(text.replace(/nodename="\w+"/, 'nodename="none"'))).validate(), "a material without its shader is valid");

    for (const m of document.getMaterialNodes()) {
        const [shader] = mx.getShaderNodes(m, mx.SURFACE_SHADER_TYPE_STRING, ""), name = m.getName();
        const definition = shader && shader.getNodeDef("");
        check(definition && definition.getName() === "ND_standard_surface_surfaceshader", name + " has no standard_surface");
        if (!definition) continue;
        const inputs = read.materials[name] = {};
        for (const i of shader.getInputs()) {
            const d = definition.getActiveInput(i.getName()), label = name + ": " + i.getName();
            check(d && d.getType() === i.getType(), label + " is none of the node's inputs, or of another type");
            if (!d) continue;
            const v = plain(i.getValue()), bound = key => d.hasAttribute(key) ? d.getAttribute(key).split(",").map(Number) : v;
            const least = bound("uimin"), most = bound("uimax");
            check(v.every((x, k) => Number.isFinite(x) && x >= least[k] && x <= most[k]), label + " is " + v);
            inputs[i.getName()] = v.length > 1 ? v : v[0];
        }
        defaults ||= Object.fromEntries(definition.getActiveInputs().filter(d => d.getValueString() !== "").map(d => [d.getName(), [d.getType(), d.getValueString()]]));
    }

    // One graph, so one shader for all: the numbers are its uniforms.
    const [first, second] = document.getMaterialNodes();
    for (const [language, generator] of Object.entries(file === files[0] ? languages : { essl: languages.essl })) {
        const g = generator.create(), context = new mx.GenContext(g);
        mx.loadStandardLibraries(context);
        const shader = g.generate(first.getName(), first, context), pixel = shader.getSourceCode("pixel");
        check(pixel.length > 1000, "no shader in " + language);
        if (language !== "essl") continue;
        const other = g.generate(second.getName(), second, context).getSourceCode("pixel");
        check(pixel.replaceAll(first.getName(), "") === other.replaceAll(second.getName(), ""), "two materials have two shaders");
        read.shader = { vertex: shader.getSourceCode("vertex"), pixel, prefix: mx.getShaderNodes(first, mx.SURFACE_SHADER_TYPE_STRING, "")[0].getName() + "_", defaults };
    }
    fs.writeFileSync(out + "/" + path.basename(file, ".mtlx") + ".json", JSON.stringify(read));
    console.log(path.basename(file) + ": " + Object.keys(read.materials).length + " materials, MaterialX " + read.version);
}

for (const file of files) await look(file);
for (const line of wrong.slice(0, 10)) console.log(line);
process.exitCode = wrong.length ? 1 : 0;
