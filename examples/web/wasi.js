// A WASI of one folder in memory, for wasm modules of wasi-libc: files are read, written, renamed and removed; nothing leaves the page.
function wasi(files) { // files: {name: Uint8Array}
  let memory;
  const open = new Map([[0, {}], [1, {}], [2, {}], [3, { folder: true }]]), text = new TextDecoder();
  const view = () => new DataView(memory.buffer), bytes = (at, n) => new Uint8Array(memory.buffer, at, n);
  const name = (at, n) => text.decode(bytes(at, n)).replace(/^(\.?\/)+/, '');
  const stat = (at, f, folder) => {
    const v = view();
    bytes(at, 64).fill(0);
    v.setUint8(at + 16, folder ? 3 : 4);
    v.setBigUint64(at + 24, 1n, true);
    v.setBigUint64(at + 32, BigInt(f && files[f] ? files[f].length : 0), true);
    return 0;
  };
  const vectors = (at, n, each) => {
    let sum = 0;
    for (let i = 0; i < n; ++i) {
      const v = view(), length = v.getUint32(at + 8 * i + 4, true), moved = each(v.getUint32(at + 8 * i, true), length);
      sum += moved;
      if (moved < length) break;
    }
    return sum;
  };
  const calls = {
    fd_prestat_get(fd, at) { if (fd !== 3) return 8; view().setUint32(at, 0, true); view().setUint32(at + 4, 1, true); return 0; },
    fd_prestat_dir_name(fd, at) { bytes(at, 1)[0] = 46; return 0; },
    fd_fdstat_get(fd, at) {
      const f = open.get(fd);
      if (!f) return 8;
      bytes(at, 24).fill(0);
      view().setUint8(at, f.folder ? 3 : fd < 3 ? 2 : 4);
      view().setBigUint64(at + 8, 0xffffffffffffffffn, true);
      view().setBigUint64(at + 16, 0xffffffffffffffffn, true);
      return 0;
    },
    fd_fdstat_set_flags: () => 0,
    fd_filestat_get(fd, at) { const f = open.get(fd); return f ? stat(at, f.name, f.folder) : 8; },
    path_filestat_get(fd, flags, at, n, out) { const f = name(at, n); return f === '' || files[f] ? stat(out, f, f === '') : 44; },
    path_open(fd, flags, at, n, how, rights, inherit, mode, out) {
      const f = name(at, n);
      if (how & 4 && files[f]) return 20;
      if (!files[f]) { if (!(how & 1)) return 44; files[f] = new Uint8Array(0); }
      if (how & 8) files[f] = new Uint8Array(0);
      let k = 4;
      while (open.has(k)) ++k;
      open.set(k, { name: f, at: 0, append: mode & 1 });
      view().setUint32(out, k, true);
      return 0;
    },
    fd_read(fd, at, n, out) {
      const f = open.get(fd);
      view().setUint32(out, vectors(at, n, (to, length) => {
        const part = files[f.name].subarray(f.at, f.at + length);
        bytes(to, part.length).set(part);
        f.at += part.length;
        return part.length;
      }), true);
      return 0;
    },
    fd_write(fd, at, n, out) {
      const f = open.get(fd);
      view().setUint32(out, vectors(at, n, (from, length) => {
        const part = bytes(from, length);
        if (fd < 3) { console.warn(text.decode(part)); return length; }
        let old = files[f.name];
        if (f.append) f.at = old.length;
        if (f.at + length > (f.size === undefined ? old.length : f.size) || !f.own) { // room for more at once
          const room = new Uint8Array(Math.max(2 * (f.at + length), 65536));
          room.set(old);
          f.size = Math.max(old.length, 0);
          f.own = room;
        }
        f.own.set(part, f.at);
        f.at += length;
        f.size = Math.max(f.size, f.at);
        if (f.size <= f.own.length) files[f.name] = f.own.subarray(0, f.size);
        return length;
      }), true);
      return 0;
    },
    fd_seek(fd, offset, whence, out) {
      const f = open.get(fd);
      if (!f || fd < 4) return 70;
      f.at = Number(offset) + (whence === 1 ? f.at : whence === 2 ? files[f.name].length : 0);
      view().setBigUint64(out, BigInt(f.at), true);
      return 0;
    },
    fd_close(fd) { open.delete(fd); return 0; },
    fd_sync: () => 0,
    path_rename(fd, at, n, fd2, at2, n2) { const f = name(at, n), g = name(at2, n2); if (!files[f]) return 44; files[g] = files[f]; delete files[f]; return 0; },
    path_unlink_file(fd, at, n) { const f = name(at, n); if (!files[f]) return 44; delete files[f]; return 0; },
    path_create_directory: () => 20,
    path_readlink: () => 28,
    clock_time_get(id, precision, at) { view().setBigUint64(at, BigInt(Math.round(performance.now() * 1e6)), true); return 0; },
    random_get(at, n) { for (let i = 0; i < n; ++i) bytes(at, n)[i] = i; return 0; },
    environ_sizes_get(a, b) { view().setUint32(a, 0, true); view().setUint32(b, 0, true); return 0; },
    environ_get: () => 0,
    proc_exit(code) { throw new Error('exit ' + code); },
  };
  const imports = new Proxy(calls, { get: (t, k) => t[k] || (() => 52), has: () => true });
  return {
    async start(binary) { // the module's exports, ready to be called
      const module = await WebAssembly.compile(binary), wanted = {};
      for (const i of WebAssembly.Module.imports(module)) (wanted[i.module] ||= {})[i.name] = imports[i.name];
      const { exports } = await WebAssembly.instantiate(module, wanted);
      memory = exports.memory;
      if (exports._initialize) exports._initialize();
      return exports;
    },
  };
}
