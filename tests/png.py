"""A reader of PNG pictures of 8-bit RGB without interlacing: all that the sheets in examples/data need."""
import functools, struct, zlib


@functools.lru_cache(maxsize=None)
def read(path):
    """Width, height and the bytes [height][width][3]."""
    with open(path, "rb") as f:
        data = f.read()
    assert data[:8] == b"\x89PNG\r\n\x1a\n", path
    at, packed, width, height = 8, b"", 0, 0
    while at < len(data):
        size, kind = struct.unpack(">I4s", data[at:at + 8])
        body = data[at + 8:at + 8 + size]
        if kind == b"IHDR":
            width, height, *form = struct.unpack(">IIBBBBB", body)
            assert form == [8, 2, 0, 0, 0], "%s: not 8-bit RGB without interlacing" % path
        elif kind == b"IDAT":
            packed += body
        at += 12 + size
    raw, stride = zlib.decompress(packed), 3 * width
    assert len(raw) == height * (stride + 1), path
    out, above = bytearray(), bytearray(stride)
    for y in range(height):
        start = y * (stride + 1)
        kind, row = raw[start], bytearray(raw[start + 1:start + 1 + stride])
        assert kind <= 4, path
        if kind == 2:
            row = bytearray(p + q & 255 for p, q in zip(row, above))
        elif kind:
            for i in range(stride):
                left, corner = (row[i - 3], above[i - 3]) if i >= 3 else (0, 0)
                if kind == 1:
                    guess = left
                elif kind == 3:
                    guess = (left + above[i]) // 2
                else:  # Paeth: the nearest to left + above - corner
                    a, b, c = abs(above[i] - corner), abs(left - corner), abs(left + above[i] - 2 * corner)
                    guess = left if a <= b and a <= c else above[i] if b <= c else corner
                row[i] = row[i] + guess & 255
        out += row
        above = row
    return width, height, bytes(out)
