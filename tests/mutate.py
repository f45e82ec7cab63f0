#!/usr/bin/env python3
"""Do a header's tests bite?  python3 tests/mutate.py HEADER [--count 20] [--seed 1] [--lines A-B] [--tests NAME,...]
                            [--scalar] [--address] [--jobs 1] [--again] [--keep]

Changes one place of the header's implementation at a time - a constant by 1 % or by one, a comparison, an operator, a dropped
statement, an intrinsic or a vector macro by its opposite - and runs the header's tests (those that include it, with
pkg_*_gpu where EGL is), the fastest first, until one fails. A change that leaves the compiled object as it was is no change and
is thrown away. Lines that this machine does not compile are left out; --scalar takes the build without SIMD. --lines: of the header, as an editor counts them.
--again runs the survivors of earlier runs once more, after tests were added; with --address under Clang's address sanitizer.
The header is compiled once a mutant, and again in tests that call its private functions. Each result is a line of
build/mutate/HEADER.tsv; the survivors are printed: some are equivalent (they change no result that is promised), the others
ask for a test. Exit 0. Needs GCC; one mutant costs a compilation and a run of each test that does not notice."""
import argparse, hashlib, json, os, random, re, signal, subprocess, sys, time
from concurrent.futures import ThreadPoolExecutor

p = argparse.ArgumentParser()
p.add_argument('header')
p.add_argument('--count', type=int, default=20)
p.add_argument('--seed', type=int, default=1)
p.add_argument('--lines')
p.add_argument('--tests')
p.add_argument('--scalar', action='store_true')
p.add_argument('--address', action='store_true')
p.add_argument('--jobs', type=int, default=1)
p.add_argument('--again', action='store_true')
p.add_argument('--keep', action='store_true', help='leaves the folder of the last mutants')
o = p.parse_args()
name = os.path.basename(o.header)[:-2]
upper = name.upper()
lines = open(name + '.h').read().split('\n')
out = 'build/mutate'
os.makedirs(out, exist_ok=True)
tsv = '%s/%s.tsv' % (out, name)
flags = '-std=c99 -O1 -w -D_POSIX_C_SOURCE=200809L -Itests -Iexamples/tools -Iexamples/demo -Iexamples/engine -Itests/bench'.split() + (['-DMS_NO_SIMD'] if o.scalar else [])
cc = ['clang', '-fsanitize=address'] if o.address else ['gcc']
nice = ['nice', '-n', '10']
inside = ['-DTEST_INSIDE=', '-include', name[3:] + '_inside.h'] if os.path.exists('tests/%s_inside.h' % name[3:]) else []
egl = subprocess.run(cc + ['-x', 'c', '-', '-o', out + '/probe', '-lEGL'], input=b'int main(void) { return 0; }', capture_output=True).returncode == 0
headers = sorted(f[:-2] for f in os.listdir('.') if re.match(r'ms_\w+\.h$', f))


def run(command, seconds):
    """Exit status and output; stops at the first line that says FAIL."""
    q = subprocess.Popen(nice + command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors='replace', start_new_session=True)
    timer = time.time() + seconds
    killer = None

    def end():
        try:
            os.killpg(q.pid, signal.SIGKILL)
        except ProcessLookupError:
            pass
    import threading
    killer = threading.Timer(seconds, end)
    killer.start()
    text = ''
    for line in q.stdout:
        text += line
        if line.startswith('FAIL'):
            end()
            break
    q.wait()
    killer.cancel()
    return ('time' if time.time() > timer else q.returncode), text


def tests_of_header():
    kind = r'(test_\w+|pkg_\w+_gpu)\.c$' if egl else r'test_\w+\.c$' # shaders where OpenGL is
    names = o.tests.split(',') if o.tests else sorted(f[:-2] for f in os.listdir('tests') if re.match(kind, f))
    return [n for n in names if re.search(r'include "%s\.h"' % name, open('tests/%s.c' % n).read()) and not n.endswith('_big_endian') and n != 'test_memory']


def linked(test):
    """The headers that a test leaves to the linker: all but those whose private text it reaches (as tests/run.sh has it)."""
    text = open('tests/%s.c' % test).read()
    return [h for h in headers if not re.search(r'(%s|%s|\bms)__|include "io\.h"' % (h, h.upper()), text)]


def reached(test):
    """Those of them that it includes, by whatever way: what is linked."""
    rule = subprocess.run(['gcc', '-I.'] + flags + ['-MM', '-MG', 'tests/%s.c' % test], capture_output=True, text=True).stdout
    return [h for h in linked(test) if re.search(r'\b%s\.h\b' % h, rule)]


def digest(path):
    return hashlib.md5(open(path, 'rb').read()).hexdigest()


def header(folder):
    """The digest of the header's object, or None where it does not compile."""
    to = '%s/%s.o' % (folder, name)
    if run(cc + ['-I' + folder, '-I.'] + flags + ['-O2', '-D%s_IMPLEMENTATION' % upper, '-D%s_WITH_SCALAR' % upper, '-include', '%s/%s.h' % (folder, name)] + inside + ['-c', '-x', 'c', '/dev/null', '-o', to], 300)[0] != 0:
        return None
    return digest(to)


def build(folder, test):
    """The digest of the test's object, or None where it does not compile."""
    to = '%s/%s.o' % (folder, test)
    made = ['-D%s_IMPLEMENTED' % h.upper() for h in linked(test)]
    if run(cc + ['-I' + folder, '-I.'] + flags + made + ['-c', 'tests/%s.c' % test, '-o', to], 300)[0] != 0:
        return None
    return digest(to)


def link(folder, test):
    base = '%s/%s' % (folder, test)
    program = ('%s/base/%s.o' % (out, test)) if name in linked(test) else base + '.o'
    objects = ['%s/%s.o' % (folder, h) if h == name else 'build/%s.o' % h for h in reached(test)]
    return run(cc + [program] + objects + ['-o', base, '-lm', '-lpthread'] + (['-lEGL'] if test.startswith('pkg_') else []), 60)[0] == 0


# --- places ---------------------------------------------------------------------------------------------------------------

def active():
    """Lines of the implementation that this machine compiles, of #define too."""
    os.makedirs(out + '/base', exist_ok=True)
    c = '%s/base/%s.c' % (out, name)
    open(c, 'w').write('#define %s_IMPLEMENTATION\n#include "%s.h"\n' % (upper, name))
    text = subprocess.run(['gcc', '-I.', '-E', '-dD'] + flags + [c], capture_output=True, text=True).stdout
    found, at, here = set(), 0, False
    for l in text.split('\n'):
        m = re.match(r'# (\d+) "([^"]*)"', l)
        if m:
            at, here = int(m.group(1)), os.path.basename(m.group(2)) == name + '.h'
        else:
            if here and l.strip():
                found.add(at)
            at += 1
    return found


def candidates():
    start = next(i for i, l in enumerate(lines) if '%s_IMPLEMENTATION) &&' % upper in l)
    seen, r, comment, skip = active(), [], False, False
    for i in range(start, len(lines)):
        l = lines[i]
        if 'ms-common' in l and 'begin' in l:
            skip = name != 'ms_mcml'
        if 'ms-common' in l and ' end ' in l:
            skip = False
        if comment:
            comment = '*/' not in l
            continue
        code = re.sub(r'/\*.*?\*/', lambda m: ' ' * len(m.group(0)), l)
        if '/*' in code:
            comment, code = True, code.split('/*')[0]
        s = code.strip()
        if skip or not s or i + 1 not in seen and not s.startswith('#define'):
            continue
        if s.startswith('#') and not re.match(r'#define %s__\w+\([^)]*\) .*(_mm|\b[+*<>-]\b)' % upper, s):
            continue
        if re.match(r'(static|MS_API|MS_\w+_API|typedef|struct|enum)\b', s) and not s.endswith(';') or 'VERSION' in s:
            continue
        r.append((i, code))
    if o.lines:
        a, b = (o.lines.split('-') + [o.lines])[:2]
        r = [(i, c) for i, c in r if int(a) <= i + 1 <= int(b)]
    return r


opposite = [('ADD', 'SUB'), ('MIN', 'MAX'), ('MUL', 'ADD'), ('LESS', 'LESS_EQUAL'), ('add', 'sub'), ('min', 'max'), ('mul', 'add'), ('and', 'or'),
            ('unpacklo', 'unpackhi'), ('slli', 'srli'), ('srli', 'slli'), ('fmadd', 'fmsub'), ('fnmadd', 'fmadd'), ('cmpgt', 'cmpeq')]


def changes(code):
    """Every change of one line: what, the new line."""
    r = []
    bare = re.sub(r'"(\\.|[^"\\])*"|\'(\\.|[^\'\\])+\'', lambda m: '"' * len(m.group(0)), code)
    bare = re.sub(r'ms__fail\(.*', lambda m: '"' * len(m.group(0)), bare)

    def put(what, m, text):
        r.append((what, code[:m.start()] + text + code[m.end():]))
    for a, b in ((' < ', ' <= '), (' <= ', ' < '), (' > ', ' >= '), (' >= ', ' > '), (' < ', ' > '), (' > ', ' < '), (' == ', ' != '), (' != ', ' == '),
                 (' && ', ' || '), (' || ', ' && '), (' + ', ' - '), (' - ', ' + '), (' * ', ' / '), (' / ', ' * '), (' += ', ' -= '), (' -= ', ' += '),
                 (' << ', ' >> '), (' & ', ' | '), (' | ', ' & '), ('++', '--')):
        for m in re.finditer(re.escape(a), bare):
            put('%s becomes %s' % (a.strip(), b.strip()), m, b)
    for m in re.finditer(r'(?<![\w.])(\d+\.\d*(?:e[+-]?\d+)?|\d+e[+-]?\d+)(f?)(?![\w.])', bare):
        if float(m.group(1)):
            put('%s times 1.01' % m.group(0), m, repr(float(m.group(1)) * 1.01) + m.group(2))
    for m in re.finditer(r'(?<![\w.])(\d+)(?![\w.])', bare):
        if len(m.group(1)) < 9 and not m.group(1).startswith('0x'):
            put('%s plus 1' % m.group(1), m, str(int(m.group(1)) + 1))
    for a, b in opposite:
        for m in re.finditer(r'(?<=%s__V_)%s(?=\()|(?<=_mm_)%s(?=_)|(?<=_mm256_)%s(?=_)|(?<=_mm512_)%s(?=_)' % (upper, a, a, a, a), bare):
            put('%s becomes %s' % (a, b), m, b)
    s = code.strip()
    if s.endswith(';') and re.match(r'[\w\[\]>.*+ -]+(\[[^;]*\])? *([-+*/|&]?=[^=]|\+\+|--)|\w+\(.*\);$', s) and \
            not re.match(r'(const |double|float|int|size_t|uint|char|return|void|break|continue|ms_\w+ \**\w+ =)', s):
        r.append(('dropped', ''))
    return r


# --- one mutant -----------------------------------------------------------------------------------------------------------

def attempt(number, i, new):
    """None: no change. Otherwise (caught by, or '')."""
    folder = '%s/%s_%d' % (out, name, number)
    os.makedirs(folder, exist_ok=True)
    text = lines[:]
    text[i] = new
    open('%s/%s.h' % (folder, name), 'w').write('\n'.join(text))
    try:
        object = header(folder)
        if object is None or object == base[name]:
            return None
        for t in tests:
            if name not in linked(t):
                of = build(folder, t)
                if of is None:
                    return None
                if of == base[t]:
                    continue
            if not link(folder, t):
                return None
            rc, said = run(['%s/%s' % (folder, t)], 20 + 5 * spent[t])
            if rc != 0:
                fail = [l for l in said.split('\n') if l.startswith('FAIL')]
                return '%s: %s' % (t, fail[0][5:80] if fail else rc)
        return ''
    finally:
        if not o.keep:
            subprocess.run(['rm', '-rf', folder])


tests = tests_of_header()
base, spent = {}, {}
os.makedirs(out + '/base', exist_ok=True)
subprocess.run(['cp', name + '.h', out + '/base/'])


def baseline(t):
    base[t] = build(out + '/base', t)
    text = '%s %s' % (base[t], base[name])
    if known.get(t, [''])[0] == text: # the last run had the same text
        spent[t] = known[t][1]
        return
    start = time.time()
    if base[t] is None or not link(out + '/base', t):
        sys.exit(t + ' does not compile')
    rc, said = run([out + '/base/' + t], 900)
    if rc != 0:
        sys.exit('%s fails unchanged: %s' % (t, said[-300:]))
    spent[t] = time.time() - start
    known[t] = [text, spent[t]]


kept = '%s/%s.json' % (out, name)
known = json.load(open(kept)) if os.path.exists(kept) else {}
subprocess.run(['make', '-s'] + ['build/%s.o' % h for h in headers if any(h in reached(t) for t in tests)], check=True)
base[name] = header(out + '/base')
with ThreadPoolExecutor(o.jobs) as pool:
    list(pool.map(baseline, tests))
json.dump(known, open(kept, 'w'))
tests.sort(key=lambda t: spent[t])
print('%s: %s' % (name, ', '.join('%s %.0f s' % (t, spent[t]) for t in tests)), flush=True)

done = {}
if os.path.exists(tsv):
    for l in open(tsv):
        f = l.rstrip('\n').split('\t')
        done[(f[3], f[4])] = f[0]
if o.again:
    work = []
    for (old, new), state in done.items():
        if state == 'SURVIVED':
            at = [i for i, l in enumerate(lines) if re.sub(r'/\*.*?\*/', '', l).strip() == re.sub(r'/\*.*?\*/', '', old).strip()]
            work += [(at[0], old, 'again', new)] if at else []
else:
    rnd = random.Random('%s %d' % (name, o.seed))
    places = candidates()
    rnd.shuffle(places)
    work = []
    for i, code in places:
        c = [x for x in changes(code) if (code, x[1]) not in done]
        if c:
            what, new = rnd.choice(c)
            work.append((i, code, what, new))

caught, survived, at = 0, [], 0
with ThreadPoolExecutor(o.jobs) as pool:
    while caught + len(survived) < (len(work) if o.again else o.count) and at < len(work):
        batch = work[at:at + o.jobs]
        at += o.jobs
        for (i, old, what, new), r in zip(batch, pool.map(lambda w: attempt(work.index(w), w[0], w[3]), batch)):
            if r is None:
                continue
            caught += r != ''
            if r == '':
                survived.append((i, what, old))
                print('SURVIVED %s.h:%d: %s: %s' % (name, i + 1, what, old.strip()[:110]), flush=True)
            else:
                print('caught   %s.h:%d: %s (%s)' % (name, i + 1, what, r), flush=True)
            open(tsv, 'a').write('%s\t%d\t%s\t%s\t%s\t%s\n' % ('caught' if r else 'SURVIVED', i + 1, what, old, new, r))
print('%s: %d of %d caught' % (name, caught, caught + len(survived)))
