// Runs a WebAssembly program of wasi-libc in Node: node tests/wasi.mjs PROGRAM.wasm ARGUMENTS. It sees the current folder.
import { readFileSync } from 'node:fs'
import { WASI } from 'node:wasi'

process.removeAllListeners('warning') // node:wasi is called experimental
const wasi = new WASI({ version: 'preview1', args: process.argv.slice(2), preopens: { '.': '.' }, returnOnExit: true })
const program = await WebAssembly.compile(readFileSync(process.argv[2]))
process.exitCode = wasi.start(await WebAssembly.instantiate(program, wasi.getImportObject()))
