"""python3 label.py FILE.safetensors KEY TEXT: one more string in the file's metadata."""
import json
import struct
import sys

path, key, text = sys.argv[1:]
with open(path, "rb") as f:
    head = json.loads(f.read(struct.unpack("<Q", f.read(8))[0]))
    tensors = f.read()
head["__metadata__"][key] = text
head = json.dumps(head, separators=(",", ":")).encode()
head += b" " * (-len(head) % 64)
with open(path, "wb") as f:
    f.write(struct.pack("<Q", len(head)) + head + tensors)
