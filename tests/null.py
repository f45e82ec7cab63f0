#!/usr/bin/env python3
"""Every public call with NULL for every pointer and zero for the rest, each in a process of its own: none may crash, and those
that return a status say MS_INVALID_ARGUMENT. The calls are read from the headers' declarations. python3 tests/null.py OUT"""
import os, re, subprocess, sys
out = sys.argv[1]
os.makedirs(out, exist_ok=True)
headers = sorted(f for f in os.listdir('.') if re.match(r'ms_\w+\.h$', f))
passed = failed = 0
for header in headers:
    name = header[:-2]
    text = subprocess.run(['gcc', '-E', '-P', '-I.', header], capture_output=True, text=True).stdout
    text = re.sub(r'__attribute__\s*\(\([^()]*(\([^()]*\))?[^()]*\)\)', '', text)
    text = re.sub(r'\s+', ' ', text)
    calls = []
    for m in re.finditer(r'(?<=[;}])\s*([A-Za-z_][\w \*]*?)\b(%s_\w+)\s*\(' % name, text):
        kind, call, at, depth = m.group(1).strip(), m.group(2), m.end(), 1
        if '__' in call or kind.startswith(('typedef', 'static', 'struct')):
            continue
        while depth:
            depth += {'(': 1, ')': -1}.get(text[at], 0)
            at += 1
        arguments = text[m.end():at - 1]
        parts, level, part = [], 0, ''
        for c in arguments:
            level += {'(': 1, ')': -1}.get(c, 0)
            if c == ',' and level == 0:
                parts.append(part)
                part = ''
            else:
                part += c
        parts.append(part)
        calls.append((kind, call, [p.strip() for p in parts if p.strip() and p.strip() != 'void']))
    source = '#include <stdio.h>\n#include <stdlib.h>\n#include <string.h>\n#define %s_IMPLEMENTATION\n#include "%s"\n' % (name.upper(), header)
    source += 'int main(int argc, char **argv) {\n switch (argc > 1 ? atoi(argv[1]) : -1) {\n'
    for k, (kind, call, parts) in enumerate(calls):
        values, before = [], ''
        for i, p in enumerate(parts):
            if '*' in p or '[' in p:
                values.append('NULL')
            else:
                what = re.sub(r'\b\w+$', '', p).strip() if len(p.split()) > 1 else p
                before += '%s v%d; memset(&v%d, 0, sizeof v%d); ' % (what.replace('const ', ''), i, i, i)
                values.append('v%d' % i)
        line = '%s(%s)' % (call, ', '.join(values))
        if kind == 'ms_status':
            line = '{ ms_status s = %s; printf("%%d\\n", (int)s); }' % line
        else:
            line += '; puts("ran");'
        source += '  case %d: { %s %s return 0; }\n' % (k, before, line)
    source += ' }\n return 1;\n}\n'
    open('%s/%s.c' % (out, name), 'w').write(source)
    built = subprocess.run(['gcc', '-std=c99', '-O0', '-w', '-DMS_NO_SIMD', '-D_POSIX_C_SOURCE=200809L', '-I.', '%s/%s.c' % (out, name), '-o', '%s/%s' % (out, name), '-lm'], capture_output=True, text=True)
    if built.returncode:
        print('FAIL %s: %s' % (header, built.stderr[:600]))
        failed += 1
        continue
    for k, (kind, call, parts) in enumerate(calls):
        pointers = [p for p in parts if '*' in p or '[' in p]
        required = [p for p in pointers if not re.search(r'ms_error \*|options \*|ms_allocator \*', p)]
        try:
            r = subprocess.run(['%s/%s' % (out, name), str(k)], capture_output=True, text=True, timeout=20)
            code, said = r.returncode, r.stdout.strip()
        except subprocess.TimeoutExpired:
            code, said = 'time', ''
        if code != 0:
            print('FAIL %s(all NULL): ends with %s' % (call, code))
            failed += 1
        elif kind == 'ms_status' and required and said != '1':
            print('FAIL %s(all NULL): status %s, expected MS_INVALID_ARGUMENT' % (call, said))
            failed += 1
        else:
            passed += 1
print('%d passed, %d failed' % (passed, failed))
sys.exit(failed > 0 or passed == 0)
