#!/bin/sh
# What can be seen without a tool that may be missing here: for each test that is skipped where its tool is not installed, a look at
# the text that it would have tried. And comments that a formatter has broken.
#   skipped without       looked at here
#   CMake, Meson          README's lines (tests/readme.sh)
#   Chromium, Node        page parts: every id that a script asks for stands in its page (page, web)
#   three.js, Babylon.js  what their modules take from WebAssembly is exported by three.c
#   glslangValidator, spirv-cross, EGL   shader files: brackets, switches that are used and listed
#   Blender, PyTorch, numpy              Python files compile; calls of a library are in its source
#   MaterialX             the writer closes what it opens
#   a locale with a decimal comma        no number is read or written by the locale in a header
#   clang-format 14       columns, tabs, blanks at ends of lines
#   other compilers, machines and C libraries (zig, 32 bits, MSVC)   what is included, no long and no extension of one compiler alone
#   GCC on x86-64 (stack of calls)       no alloca
#   (nothing)             numbers in comments stand in tests/statements, with the test that holds them
#   libFuzzer, valgrind, sanitizers      each fuzz target has a corpus (run.sh replays it)
set -u
passed=0
failed=0
check() { # NAME, then a command that must succeed
    name=$1
    shift
    if "$@" >/dev/null; then passed=$((passed + 1)); else failed=$((failed + 1)); echo "FAIL $name"; fi
}
none() { # NAME, lines that should not be there
    if [ -z "$2" ]; then passed=$((passed + 1)); else
        failed=$((failed + 1))
        echo "FAIL $1:"
        echo "$2" | head -5 | cut -c1-160
    fi
}

# ---- comments and layout
headers=$(ls ms_*.h)
none "over 120 columns" "$(awk '{gsub(/[\200-\277]/, "")} length > 120 {print FILENAME ":" FNR}' $headers)"
none "tabs, or blanks at the end of a line" "$(grep -nE '	| $' $headers)"
none "a word cut at its hyphen" "$(grep -nE '[a-z]- [a-z]' $headers | grep -vE -e '- (and|or|to) ')"
none "a value alone on a line, its name above" "$(awk 'FNR == 1 {last = ""} last ~ /[A-Z0-9_] =$/ && /^ *-?[0-9]+,/ {print FILENAME ":" FNR ": " $0} {last = $0}' $headers)"
none "two statements of an example on one line" "$(awk '/^ *[^#\/]*[a-z_]+\(.*\); ms_[a-z_]+\(/ && !/for *\(/ && !/\{.*\}/ {print FILENAME ":" FNR ": " $0}' $headers)"
none "a row of a table, or an argument, in the middle of a sentence" "$(grep -nE '^   [A-Za-z`(*][^ ]*( [^ ]+){5,}  +[A-Za-z[*`]' $headers | grep -v =)"
none "no banners of sections" "$(for h in $headers; do [ "$(grep -c '^/\* ---- ' "$h")" -gt 2 ] || echo "$h has no banners"; done)"

# ---- numbers in comments: tests/statements says where each is held to; these headers have no other
none "a number in a comment that tests/statements does not hold to (or a line of it that is out of date)" "$(awk -v headers="ms_nn.h ms_pme.h ms_mcml.h ms_gpr.h" '
    function squeezed(file,  all, line) {
        if (!(file in text)) {
            while ((getline line <file) > 0) all = all " " line
            close(file)
            gsub(/[ \t]+/, " ", all)
            text[file] = all
        }
        return text[file]
    }
    # comments of a header, but for the program in it and what all headers share
    function comments(file,  all, line, inside, skip, at, rest) {
        while ((getline line <file) > 0) {
            if (line ~ /^ *Example:$/ || line ~ /ms-common.* begin/) skip = 1
            if (!skip) {
                rest = line
                for (;;) {
                    if (!inside) {
                        if (!(at = index(rest, "/*"))) break
                        rest = substr(rest, at + 2)
                        inside = 1
                    }
                    if (!(at = index(rest, "*/"))) { all = all " " rest; break }
                    all = all " " substr(rest, 1, at - 1) " ;; "
                    rest = substr(rest, at + 2)
                    inside = 0
                }
            }
            if (line ~ /^ *End of example/ || line ~ /ms-common.* end/) skip = 0
        }
        close(file)
        gsub(/[ \t]+/, " ", all)
        return all
    }
    BEGIN {
        count = split(headers, name, " ")
        for (i = 1; i <= count; ++i) said[name[i]] = comments(name[i])
        while ((getline line <"tests/statements") > 0) {
            if (line !~ /^ms_/) continue
            split(line, part, / \| /) # a text may hold |x|, without blanks around
            if (!(part[1] in said)) said[part[1]] = comments(part[1])
            at = index(said[part[1]], part[2])
            if (!at) print part[1] " does not say: " part[2]
            else if (!index(squeezed(part[3]), part[4])) print part[3] " does not have: " part[4]
            if (at) said[part[1]] = substr(said[part[1]], 1, at - 1) "..." substr(said[part[1]], at + length(part[2]))
        }
        n = "[0-9][0-9,.]*(e-?[0-9]+)?"
        claim = n " ?(%|dB|[kKMG]B|ms|us|ns|times|digits|million|problems)[^a-zA-Z0-9_]" \
            "|(about|below|under|within|nearly|some|less than|at most|more than|over|roughly|almost) (the |a )?" n \
            "|[0-9]e-[0-9]|twice as|(half|third|quarter|sixth|tenth) (of the time|as|to a)" \
            "|(two|three|four|five|six|seven|eight|nine|ten|several) (times as|digits|million)"
        for (i = 1; i <= count; ++i)
            for (rest = said[name[i]]; match(rest, claim); rest = substr(rest, RSTART + RLENGTH))
                print name[i] ": " substr(rest, RSTART > 40 ? RSTART - 40 : 1, 100)
    }')"

none "a range in a message that the lines before it do not test" "$(awk '
    FNR == 1 {before = ""}
    {
        if (match($0, /expected [^"%]*[0-9][0-9.e+-]* to [0-9][0-9.e+-]*/)) {
            said = substr($0, RSTART, RLENGTH)
            n = split(said, word, " ")
            tested = before substr($0, 1, RSTART - 1)
            for (i = 2; i < n; ++i)
                if (word[i] == "to" && (!index(tested, word[i - 1]) || !index(tested, word[i + 1]))) print FILENAME ":" FNR ": " said
        }
        before = c3 c2 c1 $0; c3 = c2; c2 = c1; c1 = $0 " "
    }
    ' $headers)"

# ---- numbers by the locale
none "numbers by the locale in a header" "$(grep -nE '[^a-z_](strtod|strtof|atof|sscanf|localeconv) *\(' $headers)"

# ---- other compilers, machines and C libraries: these lines alone may include what not every system has
everywhere='float|limits|math|stdarg|stddef|stdint|stdio|stdlib|string'
by_platform='arm_neon|cpuid|intrin|[a-z0-9]*intrin|fcntl|sys/mman|sys/stat|unistd'
none "an include that not every C library has" "$(grep -nE '^ *# *include *<' $headers | grep -vE "<($everywhere|$by_platform)\.h>")"
none "an include of one platform outside of a condition" "$(awk 'FNR == 1 {depth = 0}
    /^ *# *if/ {condition[++depth] = $0} /^ *# *el/ {condition[depth] = condition[depth] " " $0} /^ *# *endif/ {--depth}
    /^ *# *include *<(arm_neon|cpuid|[a-z0-9]*intrin|fcntl|sys\/mman|sys\/stat|unistd)\.h/ {
        ok = 0
        for (i = 1; i <= depth; ++i) ok += condition[i] ~ /X64|NEON|ARM|POSIX|unix|APPLE|_MSC_VER|x86|GNUC|clang|__linux__|MMAP|SIMD/
        if (!ok) print FILENAME ":" FNR ": " $0
    }' $headers)"
none "long, which has 32 or 64 bits, or a format of C99 that old C libraries lack" "$(awk '{gsub(/"([^"\\]|\\.)*"/, "\"\"")} /\/\*/ {c = 1} !c && /(^|[^a-z_])long [a-z*]/ {print FILENAME ":" FNR ": " $0} /\*\// {c = 0}' $headers)"
none "memory on the stack whose size is known at run time alone" "$(grep -nE '(^|[^a-z_])(_?alloca|__builtin_alloca) *\(' $headers)"

# ---- pages
for page in studio kernels three babylon; do
    part=examples/web/$page.part.html
    [ -f "$part" ] || continue
    scripts=$(ls examples/web/$page.js examples/web/$page.page.js examples/web/$page.unpack.js 2>/dev/null)
    for id in $(cat $scripts | grep -oE "(getElementById\(|[^a-zA-Z]\\$\()'[a-zA-Z][a-zA-Z0-9_-]*'\)" | sed "s/.*'\([^']*\)'.*/\1/" | sort -u); do
        check "$page: no element '$id'" grep -qE "id=.?\"?$id[\" >\\]|for part in .*\<$id\>" "$part" $scripts examples/web/build.sh
    done
done
if [ -f examples/web/sss_three.part.js ]; then
    for name in $(grep -ohE '(exports|wasm)\.[a-z_]+' examples/web/sss_core.part.js examples/web/babylon.page.js | cut -d. -f2 | sort -u); do
        [ "$name" = memory ] || [ "$name" = _initialize ] || check "three.c does not export $name" grep -qE "export_name\(\"$name\"\)|CALL\([a-z *]+, $name," examples/web/three.c
    done
fi

# ---- shader files
for f in examples/engine/shader/*.glsl examples/engine/shader/*.wgsl; do
    [ -f "$f" ] || continue
    none "$f: brackets" "$(sed 's://.*::' "$f" | awk '{n += gsub(/\{/, "{") - gsub(/\}/, "}"); m += gsub(/\(/, "(") - gsub(/\)/, ")")} END {if (n || m) print n, m}')"
    for switch in $(grep -oE '(ifdef|ifndef|defined\() *MS_[A-Z0-9_]+' "$f" | grep -oE 'MS_[A-Z0-9_]+' | sort -u); do
        # those that all files share are explained in the first
        check "$f: $switch is not explained" sh -c "grep -E '^ *(//|/?\*|[A-Z ]).*$switch' '$f' examples/engine/shader/ms_sss.glsl"
    done
done

# ---- Python without its packages
if command -v python3 >/dev/null; then
    check "a file is no Python" python3 -c 'import ast, sys
for name in sys.argv[1:]:
    try: ast.parse(open(name).read())
    except SyntaxError as error: sys.exit("%s: %s" % (name, error))' $(git ls-files '*.py')
fi
for f in examples/blender/*.py; do # calls of the add-on's library
    for name in $(grep -oE '\b(lib|library)\.[a-z_]+' "$f" | cut -d. -f2 | sort -u); do
        check "$f calls $name, which no C file of the add-on has" grep -qE "[ *]$name\(" examples/blender/*.c
    done
done
if [ -f examples/tools/export_torch.py ]; then # types of layers that the exporter writes
    for type in $(grep -oE "[\"']type[\"']: *[\"'][a-z0-9_]+[\"']" examples/tools/export_torch.py | sed "s/.*[\"']\([a-z0-9_]*\)[\"']$/\1/" | sort -u); do
        check "ms_nn.h has no layer $type, which the exporter writes" grep -q "\"$type\"" ms_nn.h
    done
fi

# ---- MaterialX
if [ -f examples/tools/materialx.h ]; then
    for tag in $(grep -oE '<[a-z_]+ [a-z]+=' examples/tools/materialx.h | grep -oE '[a-z_]+ ' | sort -u); do
        check "materialx.h opens <$tag> and does not close it" grep -qE "</$tag>|/>" examples/tools/materialx.h
    done
    check "materialx.h writes no version" grep -q '<materialx version=' examples/tools/materialx.h
fi

# ---- fuzz targets, targets of make
for f in tests/fuzz/fuzz_*.c; do
    n=$(basename "$f" .c)
    check "$n has no corpus" sh -c "ls tests/fuzz/corpus_${n#fuzz_}/* | head -1 | grep ."
done
for target in $(grep -oE '`make [a-z-]+' README.md | cut -d' ' -f2 | sort -u); do
    check "README names make $target" grep -qE "^([a-z -]* )?$target( [a-z -]*)?:" Makefile
done
echo "$passed passed, $failed failed"
[ $failed = 0 ]
