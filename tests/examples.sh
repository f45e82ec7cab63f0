#!/bin/sh
# Runs the example programs as a user would, good input and bad: sh tests/examples.sh OUT
set -u
out=$1
mkdir -p "$out"
passed=0
failed=0
root=$(pwd)
ok() { # NAME, then a command that must succeed
    name=$1
    shift
    if "$@" >"$out/log" 2>&1; then passed=$((passed + 1)); else
        failed=$((failed + 1))
        echo "FAIL $name: $*"
        head -5 "$out/log"
    fi
}
refuses() { # NAME, text of the message, then a command that must exit with 1 or 2, say why
    name=$1
    text=$2
    shift 2
    "$@" >"$out/log" 2>&1
    rc=$?
    if { [ $rc -eq 1 ] || [ $rc -eq 2 ]; } && grep -q -i -e "$text" "$out/log"; then passed=$((passed + 1)); else
        failed=$((failed + 1))
        echo "FAIL $name: exit $rc, message: $(head -1 "$out/log")"
    fi
}
nothing_like() { # NAME, a match that writes its files, says that nothing like the picture can be drawn, and exits with 3
    name=$1
    shift
    "$@" >"$out/log" 2>&1
    rc=$?
    is "$name" "$rc $(grep -c 'can draw nothing like' "$out/log")" "3 1"
}
is() { # NAME, value, expected
    if [ "$2" = "$3" ]; then passed=$((passed + 1)); else
        failed=$((failed + 1))
        echo "FAIL $1: '$2', expected '$3'"
    fi
}

tools="mcml profile sss_kernel sss_filter postprocess lightmap recommend latent nn_info nn_run nn_quantize preview match materialx workflow train own_shader sss_wgsl demo_sss demo_match"
for tool in $tools; do
    [ -x build/$tool ] || { failed=$((failed + 1)); echo "FAIL build/$tool is not there: make first"; continue; }
    # help where it can be piped, and nothing else; a mistake: one line of usage behind what was wrong, and 2
    is "$tool --help" "$(build/$tool --help 2>/dev/null | head -1 | cut -d' ' -f1-2)" "usage: $tool"
    is "$tool --help succeeds, and says nothing else" "$(build/$tool --help 2>&1 >/dev/null; echo $?)" 0
    build/$tool --no-such-option x y z >"$out/log.out" 2>"$out/log"
    is "$tool with an unknown option" "$? $(wc -c <"$out/log.out" | tr -d ' ')" "2 0"
    is "$tool says how it is used" "$(grep -c -i -e "usage\|--help" "$out/log"), of $(wc -l <"$out/log" | awk '{print ($1 <= 2)}')" "1, of 1"
    [ ! -c /dev/full ] || is "$tool --help on a full disk" "$(build/$tool --help >/dev/full 2>/dev/null; echo $?)" 1
done

if [ -x build/profile ]; then
    is "profile lists 11 materials" "$(build/profile --list | grep -c .)" 11
    ok "profile of skin1" build/profile skin1 --csv "$out/skin1.csv"
    is "one line of totals" "$(grep -c '^# total_reflectance,' "$out/skin1.csv")" 1
    is "the column names" "$(grep -v '^#' "$out/skin1.csv" | head -1)" "r_mm,R,G,B"
    ok "profile from coefficients" build/profile --mua 0.01,0.02,0.03 --mus 1,1,1 --eta 1.4
    refuses "profile of nothing" "material" build/profile unobtainium
    refuses "negative absorption" "mu" build/profile --mua -1,0,0 --mus 1,1,1 --eta 1.4
    refuses "NaN scattering" "mu" build/profile --mua 1,0,0 --mus nan,1,1 --eta 1.4
    refuses "no arguments" "usage" build/profile
    ok "one number for all channels" build/profile --mua 0.1 --mus 1 --eta 1.3
    printf '1.0\n1\na.mco A\n1000\n0.01 0.01\n10 10 1\n2\n1\n1.4 3 20 0 0.02\n1.37 1 15 0 1e8\n1\n' >"$out/layers.mci"
    ok "profile of layers" build/profile --mci "$out/layers.mci" --csv "$out/layers.csv"
    is "its columns and rings" "$(grep -v '^#' "$out/layers.csv" | head -1), $(grep -vc '^#' "$out/layers.csv")" "r_mm,R_1/mm2,T_1/mm2, 11"
    refuses "layers and coefficients" "mci" build/profile --mci "$out/layers.mci" --eta 1
    is "a picked color comes out" "$(build/profile --color 0.5,0.25,0.125 --mfp 1 --eta 1 | awk -F, '/total_/ { printf "%.6f %.6f %.6f", $2, $3, $4 }')" "0.500000 0.250000 0.125000"
    ok "HDRP's scattering distance" build/profile --color 0.8,0.52,0.39 --distance 0.6,0.2,0.1 --csv "$out/picked.csv"
    refuses "brighter than white" "color" build/profile --color 1.2 --mfp 1
    refuses "a color without a length" "go together" build/profile --color 0.5
    ok "skin of melanin and blood" build/profile --skin melanin=0.03,blood=0.02,g=0 --csv "$out/made.csv"
    refuses "skin of something else" "foo=1" build/profile --skin foo=1
    refuses "more melanin than skin" "melanin" build/profile --skin melanin=2
fi

# One program a header, and what each finds: energies, a shadow that red light crosses, a taste, a picture, parameters.
if [ -x build/ms_mcml ]; then
    ok "ms_mcml.c" build/ms_mcml
    is "the reflectance of skin1 in ms_mcml.c" "$(build/ms_mcml | head -1)" "$(build/profile skin1 | awk -F, '/^# total_reflectance/ {printf "reflected: red %.4f, green %.4f, blue %.4f", $2, $3, $4; exit}')"
    is "all light leaves somewhere" "$(build/ms_mcml | tail -1 | awk '{print $2, $3, $4}')" "1.0000 1.0000 1.0000"
    ok "ms_sss.c" build/ms_sss "$out/shadow.ppm"
    is "red light goes furthest into the shadow" "$(build/ms_sss "$out/shadow.ppm" | awk '{gsub(",", ""); print ($7 > 1.5 * $9 && $9 > $11 && $7 < 0.5)}')" 1
    is "before and after" "$(wc -c <"$out/shadow.ppm" | tr -d ' ')" $((15 + 512 * 256 * 3))
    ok "ms_gpr.c" build/ms_gpr
    is "what it recommends is liked" "$(build/ms_gpr | awk '$NF > 5' | wc -l | tr -d ' ')" 5
    ok "ms_nn.c" build/ms_nn examples/data/renderer_128.safetensors "$out/ball.ppm"
    is "a picture of 128 x 128" "$(wc -c <"$out/ball.ppm" | tr -d ' ')" $((15 + 128 * 128 * 3))
    is "of more than one color" "$([ "$(tail -c 49152 "$out/ball.ppm" | od -An -tu1 -v -w3 | sort -u | wc -l)" -gt 1000 ] && echo yes)" yes
    ok "ms_pme.c" build/ms_pme
    is "the edit's parameters" "$(build/ms_pme | awk 'NR == 1 {gsub("[,:]", ""); print ($2 - 0.6) ^ 2 < 1e-6 && ($4 - 0.45) ^ 2 < 1e-6}')" 1
    is "the curve's parameters" "$(build/ms_pme | awk 'NR == 2 {print ($2 - 0.98) ^ 2 < 1e-4 && ($5 - 2.12) ^ 2 < 1e-4}')" 1
fi
for f in examples/ms_*.c; do # a screen for a call; ms_pme.h has two
    is "$f is short" "$([ "$(wc -l <"$f")" -lt $([ $f = examples/ms_pme.c ] && echo 70 || echo 60) ] && echo yes)" yes
done

if [ -x build/mcml ]; then
    mkdir -p "$out/mcml"
    cat >"$out/mcml/two.mci" <<'MCI'
1.0                  # file version
2                    # number of runs
a.mco A
1000
0.01 0.01
20 20 10
1
1
1.4 1 90 0.5 0.1
1
b.mco A
1000
0.01 0.01
20 20 10
2
1
1.4 1 90 0.5 0.1
1.5 0 0 0 0.1
1
MCI
    sed 's/1.4 1 90 0.5 0.1/1.4 -1 90 0.5 0.1/' "$out/mcml/two.mci" >"$out/mcml/bad.mci"
    ok "mcml runs a file" sh -c "cd '$out/mcml' && '$root/build/mcml' -s 7 two.mci"
    is "and writes both files" "$(ls "$out"/mcml/*.mco 2>/dev/null | wc -l | tr -d ' ')" 2
    cp "$out/mcml/a.mco" "$out/mcml/first.mco"
    ok "again with the same seed" sh -c "cd '$out/mcml' && '$root/build/mcml' -s 7 two.mci"
    is "gives the same numbers" "$(grep -v -i -E 'time|^#' "$out/mcml/first.mco" | cksum)" "$(grep -v -i -E 'time|^#' "$out/mcml/a.mco" | cksum)"
    rm -f "$out"/mcml/*.mco
    refuses "mcml names the line" "line 9" sh -c "cd '$out/mcml' && '$root/build/mcml' bad.mci"
    is "and writes nothing" "$(ls "$out"/mcml/*.mco 2>/dev/null | wc -l | tr -d ' ')" 0
    refuses "mcml without the file" "missing.mci" build/mcml "$out/missing.mci"
    rm -f "$out"/mcml/*.mco
    sed '1,/^b.mco/s/^1.4 1 90 0.5 0.1/1.4 1 90 0 0.1/' "$out/mcml/two.mci" >"$out/mcml/sharp.mci"
    refuses "without noise, a run that is beyond the solver is named" "run 2, b.mco" sh -c "cd '$out/mcml' && '$root/build/mcml' --exact sharp.mci"
    is "and it alone is not written" "$(cd "$out/mcml" && ls *.mco)" "a.mco"
    is "what is not computed is nan" "$(grep -c '^ *nan' "$out/mcml/a.mco")" 180
    refuses "photons without noise" "usage" build/mcml --exact -n 5 "$out/mcml/two.mci"
    sed 's/^b.mco/own.mci/' "$out/mcml/two.mci" >"$out/mcml/own.mci"
    refuses "an output over the input" "line 11" sh -c "cd '$out/mcml' && '$root/build/mcml' own.mci"
    refuses "a share that is no number" "usage" build/mcml --run "$out/mcml/two.mci" 1x 2 "$out/mcml/1.tally"
    refuses "a seed beyond 2^64" "usage" build/mcml -s 18446744073709551616 "$out/mcml/two.mci"
    for share in 1 2; do build/mcml --run "$out/mcml/two.mci" $share 2 "$out/mcml/$share.tally"; done
    build/mcml --run "$out/mcml/two.mci" 2 4 "$out/mcml/quarter.tally"
    ok "two shares make a run" sh -c "cd '$out/mcml' && '$root/build/mcml' --merge two.mci 2.tally 1.tally"
    refuses "the same share twice" "1.tally has, too" build/mcml --merge "$out/mcml/two.mci" "$out/mcml/1.tally" "$out/mcml/1.tally"
    refuses "a share of another split" "1.tally has, too" build/mcml --merge "$out/mcml/two.mci" "$out/mcml/1.tally" "$out/mcml/quarter.tally"
fi

if [ -x build/sss_kernel ]; then
    ok "kernel of a material" build/sss_kernel skin1 --model preintegrated --taps 7
    ok "kernel of a CSV" build/sss_kernel "$out/skin1.csv" --taps 9
    ok "fewest taps of a model" build/sss_kernel skin1 --model preintegrated --taps 33 --tolerance 0.06
    refuses "a tolerance out of reach" "asked for" build/sss_kernel skin1 --taps 3 --tolerance 0.001
    refuses "kernel of nothing" "unobtainium" build/sss_kernel unobtainium
fi

if [ -x build/sss_filter ]; then
    # a 64 x 32 picture: the left half lit, at a depth of 2; little-endian PFM through awk and printf
    pfm() { # FILE, channels, octal bytes of the left half's float, of the right half's
        { if [ "$2" = 3 ]; then printf 'PF\n64 32\n-1.0\n'; else printf 'Pf\n64 32\n-1.0\n'; fi
          awk -v n="$2" -v a="$3" -v b="$4" 'BEGIN {for (y = 0; y < 32; y++) for (x = 0; x < 64; x++) for (c = 0; c < n; c++) printf "%s", x < 32 ? a : b}' |
              while read -r line; do printf "$line"; done; } >"$1"
    }
    one='\\000\\000\\200\\077\n'
    zero='\\000\\000\\000\\000\n'
    two='\\000\\000\\000\\100\n'
    pfm "$out/e.pfm" 3 "$one" "$zero"
    pfm "$out/d.pfm" 1 "$two" "$two"
    ok "filter to PFM" build/sss_filter "$out/e.pfm" "$out/d.pfm" "$out/f.pfm" --material skin1 --mm-per-unit 10
    ok "filter to PNG" build/sss_filter "$out/e.pfm" "$out/d.pfm" "$out/f.png" --profile "$out/skin1.csv" --taps 9 --ortho 2 --mm-per-unit 1 --strength 0.5
    for m in taps pyramid gather; do
        ok "filter by $m" build/sss_filter "$out/e.pfm" "$out/d.pfm" "$out/$m.pfm" --material skin1 --mm-per-unit 10 --method "$m"
    done
    is "the method is said" "$(build/sss_filter "$out/e.pfm" "$out/d.pfm" "$out/pyramid.pfm" --material skin1 --mm-per-unit 10 --method pyramid | grep -c '^pyramid')" 1
    is "the size stays" "$(head -c 9 "$out/f.pfm" | tail -c 6 | head -1)" "64 32"
    head -c 3000 "$out/e.pfm" >"$out/cut.pfm"
    rm -f "$out/never.pfm"
    refuses "a truncated picture" "cut.pfm" build/sss_filter "$out/cut.pfm" "$out/d.pfm" "$out/never.pfm" --material skin1
    refuses "what looks like meters" "mm_per_unit" build/sss_filter "$out/e.pfm" "$out/d.pfm" "$out/never.pfm" --material skin1
    refuses "an unknown material" "material" build/sss_filter "$out/e.pfm" "$out/d.pfm" "$out/never.pfm" --material unobtainium
    refuses "an even number of taps or none" "taps" build/sss_filter "$out/e.pfm" "$out/d.pfm" "$out/never.pfm" --material skin1 --taps 0
    is "nothing is written" "$(ls "$out/never.pfm" 2>/dev/null)" ""
fi

if [ -x build/postprocess ]; then
    ok "post-process" build/postprocess "$out/post.png"
    is "the method is said" "$(build/postprocess "$out/post.png" --method pyramid)" pyramid
    ok "lightmap" build/lightmap "$out/e.pfm" "$out/lightmap.png" --texels-per-mm 4
    refuses "a lightmap that is not there" "missing.pfm" build/lightmap "$out/missing.pfm" "$out/never.png" --texels-per-mm 4
fi

if [ -x build/recommend ]; then
    awk 'BEGIN {srand(1); for (i = 0; i < 60; i++) {s = 0; for (j = 0; j < 4; j++) {x = rand(); printf "%.6f,", x; s += (x - 0.5) * (x - 0.5)} printf "%.3f\n", s < 0.4 ? 10 * (1 - s / 0.4) : 0}}' >"$out/scores.csv"
    ok "recommendations" build/recommend "$out/scores.csv" --count 20 --tau 0.5 --seed 3 --out "$out/r.csv"
    is "as many as asked for" "$(grep -v '^#' "$out/r.csv" | grep -c '^[0-9]')" 20
    is "it says what is liked" "$(build/recommend "$out/scores.csv" --tau 0.8 2>&1 >/dev/null | grep -c '^liked for: x[0-3] 0\.[0-9]* to 0\.')" 1
    # too few scores for a threshold: four of five are above the floor, one of them is 2
    printf '0.1,0.2,8\n0.3,0.1,2\n0.5,0.9,9\n0.2,0.4,7\n0.9,0.3,1\n' >"$out/five.csv"
    is "what variants are of" "$(build/recommend "$out/five.csv" --count 3 2>&1 >/dev/null | grep -c '^warning: .* variants of the 4 materials scored above 1\.')" 1
    printf '0.1,0\n' >"$out/one.csv"
    is "one of each" "$(build/recommend "$out/one.csv" --count 1 2>&1 >/dev/null | grep -c -e '^warning: no score is above 0 yet' -e '^1 score of 1 parameter;' -e '^1 recommendation\.')" 3
    # what is kept: a range in steps, two equal columns, a list of metals of which one is not in the range; then 20 more, and others than those
    printf 'x2,x3\n0.4,0.5\n0.6,0.45\n0.9,0.5\n' >"$out/metals.csv"
    set -- "$out/scores.csv" --tau 0.5 --seed 3 --keep x0=0.1:0.9:0.01 --keep x1=x0 --keep x2=0:0.8 --list "$out/metals.csv"
    ok "wishes" build/recommend "$@" --count 40 --out "$out/kept.csv"
    is "all are kept" "$(awk -F, 'NR > 1 && ($3 " " $4 == "0.4 0.5" || $3 " " $4 == "0.6 0.45") && $2 == $1 && $1 ~ /^0.[1-9][0-9]?$/' "$out/kept.csv" | wc -l | tr -d ' ')" 40
    ok "20 more" build/recommend "$@" --count 20 --skip 20 --out "$out/more.csv"
    is "are the next 20" "$(sed 1d "$out/more.csv" | cksum)" "$(sed 1,21d "$out/kept.csv" | cksum)"
    sed 4q "$out/kept.csv" >"$out/avoid.csv"
    ok "not like these" build/recommend "$@" --count 5 --avoid "$out/avoid.csv" --out "$out/other.csv"
    is "are none of them" "$(sed 1d "$out/other.csv" | grep -cFf "$out/avoid.csv")" 0
    is "what is not there is said" "$(build/recommend "$out/scores.csv" --tau 0.5 --keep x0=0.1:0.9:0.2 --keep x1=x0 --keep x2=0.5 --keep x3=0.5 2>&1 >"$out/few.csv" | grep -c '^warning: gave up.*no other materials')" 1
    is "and what is there is written" "$(sed 1d "$out/few.csv" | sort | uniq -d | wc -l | tr -d ' ') $(sed 1d "$out/few.csv" | grep -c .)" "0 $(sed 1d "$out/few.csv" | sort -u | grep -c .)"
    awk -F, -v OFS=, 'NR == 9 || NR == 20 {$5 = 100} {print}' "$out/scores.csv" >"$out/slips.csv"
    is "two slips do not hide each other" "$(build/recommend "$out/slips.csv" --count 5 2>&1 >/dev/null | grep -c '^warning: is that a slip? score 9 is 100')" 1
    awk -F, -v OFS=, 'NR == 9 || NR == 20 {$2 = 100 * $2} {print}' "$out/scores.csv" >"$out/slips.csv"
    is "nor two cells in percent" "$(build/recommend "$out/slips.csv" --count 5 2>&1 >/dev/null | grep -c '^warning: is that a slip? x1 of material \(9\|20\)')" 1
    awk 'BEGIN {srand(7); for (i = 0; i < 60; i++) {for (j = 0; j < 4; j++) printf "%.6f,", rand(); print int(11 * rand())}}' >"$out/random.csv"
    is "random scores are named" "$(build/recommend "$out/random.csv" --count 5 2>&1 >/dev/null | grep -c '^warning: these scores predict each other no better')" 1
    awk 'BEGIN {srand(1); for (i = 0; i < 60; i++) {for (k = 0; k < 4; k++) x[k] = rand(); if (i >= 40) x[0] = 0.5 + x[0] / 2
        s = i < 40 ? (x[0] - 0.4) / 0.6 : (0.4 - x[1]) / 0.4
        printf "%.3f,%.3f,%.3f,%.3f,%d\n", x[0], x[1], x[2], x[3], (s > 0 ? 10 * s + 0.5 : 0)}}' >"$out/changed.csv"
    is "a changed taste is asked about" "$(build/recommend "$out/changed.csv" --count 5 2>&1 >/dev/null | grep -c '^warning: the last 20 scores are lower')" 1
    refuses "a sum of parameters" "no column is called 'x0 - x1" build/recommend "$out/scores.csv" --keep "x0 - x1 = 1.5"
    refuses "a metal that is not there" "none of its 3 rows" build/recommend "$out/scores.csv" --keep x2=0.1 --list "$out/metals.csv"
    refuses "equal columns without a value in common" "no value is in both ranges" build/recommend "$out/scores.csv" --keep x0=0:0.2 --keep x1=0.5:1 --keep x0=x1
    refuses "a parameter that is not there" "x0=x4: 'x4' is neither a number nor the name of a column" build/recommend "$out/scores.csv" --keep x0=x4
    refuses "a part of a material left out" "expected a whole number" build/recommend "$out/scores.csv" --skip 1.5
    refuses "a seed of a fraction" "expected a whole number" build/recommend "$out/scores.csv" --seed 0.5
    refuses "no number at all" "a wish is none of" build/recommend "$out/scores.csv" --keep x0=nan
    refuses "a parameter kept at infinity" "a wish is none of" build/recommend "$out/scores.csv" --keep x0=1e400
    refuses "a range without its end" "a wish is none of" build/recommend "$out/scores.csv" --keep x0=0.5:
    ok "a threshold just above the floor" build/recommend "$out/scores.csv" --count 1 --tau 1e-9
    head -n 1 "$out/metals.csv" >"$out/none.csv"
    refuses "a list of no rows" "none.csv: holds no rows" build/recommend "$out/scores.csv" --list "$out/none.csv"
    refuses "a list without names" "does not name the columns" build/recommend "$out/scores.csv" --list "$out/scores.csv"
    refuses "too few columns to avoid" "fewer columns" build/recommend "$out/scores.csv" --avoid "$out/metals.csv"
    ok "the plane" build/latent "$out/scores.csv" "$out/plane.png"
    ok "with pictures on it" build/latent examples/data/scores.csv "$out/pictures.png" examples/data/renderer_64.safetensors
    refuses "a renderer of other parameters" "another number of parameters" build/latent "$out/scores.csv" "$out/never.png" examples/data/renderer_64.safetensors
    printf '0.1,0.2,5\n0.1,nan,5\n' >"$out/bad.csv"
    refuses "NaN in the scores" "2" build/recommend "$out/bad.csv"
    refuses "no file" "missing.csv" build/recommend "$out/missing.csv"
    # "the best 1 of 4", ten times over, by somebody who likes the first parameter large: nobody scored anything
    awk 'BEGIN {srand(3); for (i = 0; i < 40; ++i) printf "%f,%f,%f,\n", rand(), rand(), rand()}' >"$out/shown.csv"
    awk -F, '{x[NR] = $1} END {for (g = 0; g < 40; g += 4) {b = g + 1; for (i = g + 1; i <= g + 4; ++i) if (x[i] > x[b]) b = i
        for (i = g + 1; i <= g + 4; ++i) if (i != b) print b "," i}}' "$out/shown.csv" >"$out/pairs.csv"
    ok "comparisons alone" build/recommend "$out/shown.csv" --pairs "$out/pairs.csv" --count 20 --tau 0.8 --out "$out/r4.csv"
    is "they are like what was preferred" "$(awk -F, 'NR > 1 {s += $1} END {print (s / (NR - 1) > 0.7)}' "$out/r4.csv")" 1
    refuses "materials without a score and without comparisons" "line 1" build/recommend "$out/shown.csv"
    echo 3,41 >"$out/beyond.csv"
    refuses "a comparison of what is not there" "line 1" build/recommend "$out/shown.csv" --pairs "$out/beyond.csv"
    refuses "a wrong value of an option, by name" "--tau 1.5: expected a number above 0, at most 1" build/recommend "$out/scores.csv" --tau 1.5
    refuses "an option that is not there" "--colour" build/recommend "$out/scores.csv" --colour red
    # the same table as people have it: names, the score not last, row numbers, texts, quotes, a missing score, trailing separators, CR LF
    awk -F, 'BEGIN {print "sep=;\r\n;\"made of\";roughness;Stars;\"sheen;\"\"x\"\"\";ior;red;\r"}
        {t = NR - 1 ";\"a;b" NR "\";" $1 ";" $5 ";" $2 ";" $3 ";" $4 ";\r"; gsub(/\./, ",", t); print t}
        END {print "99;last;0,5;;0,5;0,5;0,5;\r"}' "$out/scores.csv" >"$out/names.csv"
    ok "a table with names" build/recommend "$out/names.csv" --count 20 --tau 0.5 --seed 3 --out "$out/named.csv"
    is "says what was left out" "$(grep -c "^Of the file, the row numbers.*'made of' are left out, 1 line without a score skipped\.$" "$out/log")" 1
    is "and is the same table" "$(sed 1d "$out/named.csv" | cksum)" "$(sed 1d "$out/r.csv" | cksum)"
    is "with its names" "$(sed 1q "$out/named.csv")" 'roughness,"sheen;""x""",ior,red,mean,sigma'
    is "liked for names" "$(build/recommend "$out/names.csv" --tau 0.8 2>&1 >/dev/null | grep -c '^liked for: \(roughness\|sheen;"x"\|ior\|red\) 0\.[0-9]* to 0\.')" 1
    build/recommend "$out/names.csv" --keep roughness=0.4 --keep ior=red --tau 0.5 --count 20 --out "$out/kept.csv" 2>/dev/null
    is "kept by name" "$(awk -F, 'NR > 1 && $1 == 0.4 && $3 == $4' "$out/kept.csv" | wc -l | tr -d ' ')" 20
    refuses "a name that is not there" "no column is called 'sheen'" build/recommend "$out/names.csv" --keep sheen=0.2
    printf 'metal,red,ior\ngold,0.4,0.5\ncopper,0.6,0.45\n' >"$out/metals.csv"
    build/recommend "$out/names.csv" --list "$out/metals.csv" --tau 0.5 --count 10 --out "$out/kept.csv" 2>/dev/null
    is "a list by names, with texts in it" "$(awk -F, 'NR > 1 && ($4 " " $3 == "0.4 0.5" || $4 " " $3 == "0.6 0.45")' "$out/kept.csv" | wc -l | tr -d ' ')" 10
    awk -F, 'NR == 1 {for (i = 0; i < 5; i++) printf ",%d", i; print ""} {print NR - 1 "," $0}' "$out/scores.csv" >"$out/pandas.csv"
    build/recommend "$out/pandas.csv" --count 20 --tau 0.5 --seed 3 --out "$out/named.csv" 2>/dev/null
    is "a table of pandas" "$(cksum <"$out/named.csv")" "$(cksum <"$out/r.csv")"
    is "a best that no score reached is said" "$(build/recommend "$out/names.csv" --count 1 2>&1 >/dev/null | grep -c 'the best predicted score is [0-9.]*\(, above the best that was given, [0-9.]*\)*\.$')" 1
    sed '5s/;0,/;o,/' "$out/names.csv" >"$out/bad.csv"
    refuses "a bad cell, by its name" "bad.csv: column 3 (roughness) is 'o,[0-9]*', a finite number was expected (line 5)" build/recommend "$out/bad.csv"
    sed '6s/"//' "$out/names.csv" >"$out/bad.csv"
    refuses "a quote that is open" "" build/recommend "$out/bad.csv"
    : >"$out/empty.csv"
    refuses "no comparisons" "holds no rows" build/recommend "$out/shown.csv" --pairs "$out/empty.csv"
fi

if [ -x build/nn_info ]; then
    ok "layers of a network" build/nn_info tests/data/nn/renderer_f16.safetensors
    printf 'not a network' >"$out/bad.safetensors"
    refuses "not a network" "header" build/nn_info "$out/bad.safetensors"
fi

if [ -x build/own_shader ] && [ -x build/train ]; then # a shader of one's own, end to end, small
    ok "own_shader.sh" env COUNT=200 SIZE=16 STEPS=100 TRAIN="--epochs 60 --width 48 --rank 16" sh examples/tools/own_shader.sh "$out/own"
    is "it finds that the channels share" "$(sed -n 's/^channels: share a network, inputs \(.*\) of.*/\1/p' "$out/own/train.txt")" "0,3,6,7,8,9;1,4,6,7,8,9;2,5,6,7,8,9"
    is "names in the answers" "$(head -1 "$out/own/match_00003.csv")" "$(head -1 "$out/own/pictures.csv")"
    is "recommendations that are red metal" "$(awk -F, 'NR > 1 { n += ($9 > .5 && $1 > $2) } END { print (n >= 12) }' "$out/own/recommended.csv")" 1
    refuses "pictures in no folder" "cannot" build/own_shader /dev/null/x 2
fi

if [ -x build/preview ]; then
    net=tests/data/nn/renderer_f16.safetensors # 19 parameters to 8 x 8 pixels
    row() { awk -v n="$1" -v k="${2:-0}" -v v="${3:-}" 'BEGIN {for (i = 1; i <= n; i++) printf "%s%s", (i > 1 ? "," : ""), (i == k ? v : 0.05 * i); print ""}'; }
    { row 19; row 19 3 1; row 19 19 0; } >"$out/rows.csv"
    ok "a sheet of three" build/preview $net "$out/rows.csv" "$out/sheet.ppm"
    is "two in a row, gaps around" "$(head -2 "$out/sheet.ppm" | tail -1)" "22 22"
    sed '1i\
'"$(row 19 | sed 's/[^,]*/x/g'),score" "$out/rows.csv" | sed '2,$s/$/,9/' >"$out/scored.csv"
    ok "a gallery with scores" build/preview $net "$out/scored.csv" "$out/scored.ppm"
    is "draws the same" "$(cksum <"$out/scored.ppm")" "$(cksum <"$out/sheet.ppm")"
    for bad in "18 columns:18 0" "20 columns:20 0" "nan:19 3 nan" "outside:19 4 1.01" "outside:19 19 -0.01" "not a number:19 5 abc" "not a number:19 5 "; do
        { row 19; row ${bad#*:}; } >"$out/bad.csv"
        refuses "preview of ${bad#*:}" "line 2.*${bad%%:*}" build/preview $net "$out/bad.csv" "$out/never.png"
    done
    : >"$out/bad.csv"
    refuses "preview of nothing" "no materials" build/preview $net "$out/bad.csv" "$out/never.png"
    refuses "preview without the file" "missing.csv" build/preview $net "$out/missing.csv" "$out/never.png"
    refuses "a network that draws no picture" "picture" build/preview tests/data/nn/inversion_small_valid_channels_first.safetensors "$out/rows.csv" "$out/never.png"
    refuses "a truth of another size" "size" build/preview $net "$out/rows.csv" "$out/never.png" "$out/sheet.ppm"
    is "nothing is drawn" "$(ls "$out/never.png" 2>/dev/null)" ""
fi

if [ -x build/match ]; then
    net=tests/data/nn/renderer_f16.safetensors # 19 parameters to 8 x 8 pixels
    gray() { printf "$1"; awk -v n="$2" 'BEGIN {for (i = 0; i < n; i++) printf "%c", 97 + i % 7}'; } # header, bytes
    gray 'P6\n8 8\n255\n' 192 >"$out/t.ppm"
    gray 'P5\n4 4\n255\n' 16 >"$out/small.pgm"
    gray 'P5\n8 8\n255\n' 64 >"$out/mask.pgm"
    { printf 'P5\n8 8\n255\n'; head -c 64 /dev/zero; } >"$out/none.pgm"
    { printf 'PF\n8 8\n-1.0\n'; head -c 764 /dev/zero; printf '\000\000\300\177'; } >"$out/nan.pfm"
    # a network without training, which draws nothing like these
    nothing_like "a material for a picture" build/match $net "$out/t.ppm" --weights "$out/mask.pgm" --out-params "$out/match.csv" --out-png "$out/match.png"
    is "a row of parameters" "$(awk -F, 'END {print NF}' "$out/match.csv")" 19
    nothing_like "starts from it again" build/match $net "$out/t.ppm" --start "$out/match.csv" --cost 5
    nothing_like "a target of another size, gray" build/match $net "$out/small.pgm"
    is "is said on stderr" "$(build/match $net "$out/small.pgm" 2>&1 >/dev/null | grep -c "4 x 4 pixels, brought to the renderer's 8 x 8")" 1
    refuses "NaN in the target" "finite" build/match $net "$out/nan.pfm" --out-params "$out/never.csv"
    refuses "no weights" "weight is 0" build/match $net "$out/t.ppm" --weights "$out/none.pgm"
    refuses "no target" "missing.ppm" build/match $net "$out/missing.ppm"
    refuses "no network" "missing.safetensors" build/match "$out/missing.safetensors" "$out/t.ppm"
    refuses "no renderer" "picture" build/match tests/data/nn/act_elu.safetensors "$out/t.ppm"
    refuses "no folder" "missing" build/match $net "$out/t.ppm" --inversion "$out/missing"
    refuses "an inversion network of another size" "inversion_small" build/match $net "$out/t.ppm" --inversion tests/data/nn
    refuses "an unknown option" "usage" build/match $net "$out/t.ppm" --quickly 1
    is "nothing is written by failures" "$(ls "$out/never.png" "$out/never.csv" 2>/dev/null)" ""
fi

if [ -x build/workflow ]; then
    refuses "workflow of nothing" "usage" build/workflow
    refuses "an unknown taste" "--taste salt: expected metal, glass or jade" build/workflow "$out" --taste salt
    refuses "no networks" "preview_64" build/workflow "$out" --networks "$out/nowhere"
fi
if [ -x build/workflow ] && [ -f examples/data/inversion_1.safetensors ]; then
    mkdir -p "$out/a" "$out/b"
    ok "the whole workflow" build/workflow "$out/a" 
    is "all files" "$(cd "$out/a" && echo *)" "chosen.csv gallery.csv recommended.csv times.md workflow.mtlx workflow.png"
    is "120 scores" "$(grep -c '^[0-9]' "$out/a/gallery.csv")" 120
    is "300 recommendations" "$(grep -c '^[0-9]' "$out/a/recommended.csv")" 300
    ok "scores of a file" build/workflow "$out/b" --scores "$out/a/gallery.csv"
    is "with those scores" "$(cksum <"$out/b/gallery.csv")" "$(cksum <"$out/a/gallery.csv")"
    ok "a sheet of the recommendations" build/preview examples/data/preview_64.safetensors "$out/a/recommended.csv" "$out/recommended.png"
    ok "a sheet of the variants" build/preview examples/data/renderer_128.safetensors "$out/a/chosen.csv" "$out/chosen.png"
    if command -v python3 >/dev/null 2>&1; then ok "the MaterialX file" python3 tests/materialx.py "$out/a"; fi
    ok "the recommendations alone as MaterialX" build/materialx "$out/a/recommended.csv" "$out/mtlx/recommended.mtlx" --name recommended
    is "with the same names and inputs" "$(sed -n '/<standard_surface name="recommended_/,/<\/standard_surface/s/ value=.*//p' "$out/mtlx/recommended.mtlx" | cksum)" \
        "$(sed -n '/<standard_surface name="recommended_/,/<\/standard_surface/s/ value=.*//p' "$out/a/workflow.mtlx" | cksum)"
    refuses "MaterialX of no materials" "number\|columns" build/materialx README.md "$out/mtlx/none.mtlx"
    refuses "a name that MaterialX does not allow" "usage" build/materialx "$out/a/recommended.csv" "$out/mtlx/none.mtlx" --name 3d
    is "nothing written then" "$(ls "$out/mtlx")" recommended.mtlx
    sed '3s/^[^,]*/1.5/' "$out/a/gallery.csv" >"$out/bad.csv"
    refuses "scores of an impossible material" "is 1.5, outside of 0 to 1 (line 3)" build/workflow "$out/b" --scores "$out/bad.csv"
    awk -F, -v OFS=, 'NR > 1 {$20 = 0} {print}' "$out/a/gallery.csv" >"$out/bad.csv"
    refuses "scores of one who likes nothing" "score" build/workflow "$out/b" --scores "$out/bad.csv"
    ok "an output folder that is made" build/workflow "$out/nowhere/deep"
    is "with all files" "$(ls "$out/nowhere/deep" | wc -l | tr -d ' ')" "$(ls "$out/a" | wc -l | tr -d ' ')"
fi

# Results: a folder or a device is left alone, missing folders are made, a full disk leaves the old file and nothing beside
# it, and what is printed and does not arrive is an error.
net=tests/data/nn/renderer_f16.safetensors
awk 'BEGIN {for (r = 0; r < 2; r++) {for (i = 0; i < 19; i++) printf "%s0.%d", (i ? "," : ""), i % 10; print ""}}' >"$out/two.csv"
printf '1.0\n1\n%s A\n1000\n0.01 0.01\n20 20 10\n1\n1\n1.4 1 90 0.5 0.1\n1\n' "$out/part.mco" >"$out/part.mci"
result() { # NAME, the line of shell with RESULT for the file that it writes, ending, blocks of a full disk, exit code of success
    name=$1
    command=$2
    run() { sh -c "$(printf '%s' "$command" | sed "s|RESULT|$1|g")" >"$out/log.out" 2>"$out/log"; echo $?; }
    rm -rf "$out/made"
    is "$name: folders are made" "$(run "$out/made/a/b/file$3") $(ls "$out/made/a/b" 2>/dev/null)" "${5:-0} file$3"
    mkdir -p "$out/a_folder$3"
    is "$name: a folder is left alone" "$(run "$out/a_folder$3") $(ls -d "$out/a_folder$3") $(grep -c "a_folder" "$out/log")" "1 $out/a_folder$3 1"
    is "$name: a file is no folder" "$(run "$out/two.csv/x$3")" 1
    # at most one block a file: as on a full disk, but without one
    rm -rf "$out/full" && mkdir "$out/full" && echo old >"$out/full/file$3"
    is "$name: a full disk" "$( (ulimit -f ${4:-1}; trap '' XFSZ; run "$out/full/file$3")) $(ls "$out/full") $(cat "$out/full/file$3")" "1 file$3 old"
}
result "profile" "build/profile skin1 --csv RESULT" .csv
result "recommend" "build/recommend '$out/scores.csv' --count 20 --out RESULT" .csv
result "latent" "build/latent '$out/scores.csv' RESULT" .png
result "postprocess" "build/postprocess RESULT" .png
result "lightmap" "build/lightmap '$out/e.pfm' RESULT --texels-per-mm 4" .pfm
result "sss_filter" "build/sss_filter '$out/e.pfm' '$out/d.pfm' RESULT --material skin1 --mm-per-unit 10" .pfm
result "preview" "build/preview tests/data/nn/renderer_f16.safetensors '$out/two.csv' RESULT" .ppm
result "match" "build/match $net '$out/t.ppm' --cost 5 --out-png RESULT" .png 0 3
rm -rf "$out/full" && mkdir "$out/full"
is "demo_sss: a full disk" "$( (ulimit -f 1; trap '' XFSZ; build/demo_sss "$out/full" --width 64 >/dev/null 2>&1; echo $?)) $(ls "$out/full" | grep -c -e '\.new' -e html -e txt)" "1 0"
result "mcml --run" "build/mcml --run '$out/part.mci' 1 2 RESULT" .tally
if [ -c /dev/full ]; then
    printed() { # NAME, a command that prints
        name=$1
        shift
        is "$name: standard output on a full disk" "$("$@" >/dev/full 2>"$out/log"; echo "$?") $(grep -c "standard output" "$out/log")" "1 1"
    }
    printed profile build/profile skin1
    printed "profile --list" build/profile --list
    printed "profile --csv" build/profile skin1 --csv "$out/skin1.csv"
    printed sss_kernel build/sss_kernel skin1 --model preintegrated --taps 7
    printed recommend build/recommend "$out/scores.csv" --count 20
    printed latent build/latent "$out/scores.csv" "$out/plane.png"
    printed lightmap build/lightmap "$out/e.pfm" "$out/lightmap.png" --texels-per-mm 4
    printed nn_info build/nn_info $net
    printed nn_run build/nn_run $net "$out/two.csv"
    printed nn_quantize build/nn_quantize $net "$out/q.safetensors" --type i8
    printed preview build/preview $net "$out/two.csv" "$out/sheet.ppm"
    printed match build/match $net "$out/t.ppm" --cost 5
fi

# A network in narrower types runs, and loses what such rounding loses: 8 bits of 1 part in 254 a row leave over 50 dB, 8 of 20 directions over 35.
psnr() { build/nn_quantize "$@" | sed -n 's/.*inputs: \([0-9]*\)\..*/\1/p'; }
is "nn_quantize: i8, then f16 of a lower rank" "$(test "$(psnr $net "$out/q.safetensors" --type i8)" -ge 50 && echo 50) \
$(test "$(psnr $net "$out/q.safetensors" --type f16 --rank 8 --samples 300)" -ge 35 && echo 35) $(build/nn_info "$out/q.safetensors" | grep -c fc2)" "50 35 2"
one_weight() { # NAME of the layer, its weight in octal bytes
    printf '\0\1\0\0\0\0\0\0%-256s'"$2" '{"__metadata__":{"ms_nn_version":"1","ms_nn_input":"[1]","ms_nn_layers":"[{\"type\":\"dense\",\"name\":\"'"$1"'\",\"bias\":false}]"},"'"$1"'.weight":{"dtype":"F32","shape":[1,1],"data_offsets":[0,4]}}'
}
one_weight f '\0\270\210G' >"$out/70000.safetensors"
one_weight f '\0\0\300\177' >"$out/nan.safetensors"
one_weight f}{ '\0\0\200?' >"$out/braces.safetensors"
refuses "nn_quantize: a weight beyond f16, by name" "'f.weight' has a weight of 70000" build/nn_quantize "$out/70000.safetensors" "$out/q.safetensors" --type f16
refuses "nn_quantize: i8 has no NaN" "'f.weight'" build/nn_quantize "$out/nan.safetensors" "$out/q.safetensors" --type i8
is "nn_quantize: NaN is not equal" "$(build/nn_quantize "$out/nan.safetensors" "$out/q.safetensors" --type f16 | grep -c NaN)" 1
refuses "nn_quantize: a name that the list's braces hide in" "odd" build/nn_quantize "$out/braces.safetensors" "$out/q.safetensors" --type f16 --rank 1
printf '\357\273\2772\n' >"$out/mark.csv"
is "nn_run: a byte order mark" "$(build/nn_run "$out/braces.safetensors" "$out/mark.csv")" 2
is "nn_quantize: a type that is none" "$(build/nn_quantize $net "$out/q.safetensors" --type f8 2>/dev/null; echo $?)" 2

# Tables as spreadsheets write them: semicolons and decimal commas, a byte order mark; UTF-16 is named.
{ printf '\357\273\277'; sed 's/,/;/g; s/\./,/g' "$out/scores.csv"; } >"$out/comma.csv"
ok "recommendations for a table with decimal commas" build/recommend "$out/comma.csv" --count 20 --tau 0.5 --seed 3 --out "$out/r2.csv"
build/recommend "$out/scores.csv" --count 20 --tau 0.5 --seed 3 --out "$out/r.csv" 2>/dev/null
is "are the same" "$(cksum <"$out/r2.csv")" "$(cksum <"$out/r.csv")"
sed 's/,/;/g; s/\./,/g' "$out/two.csv" >"$out/two_comma.csv"
build/preview $net "$out/two.csv" "$out/s1.ppm" >/dev/null
ok "a sheet of a table with decimal commas" build/preview $net "$out/two_comma.csv" "$out/s2.ppm"
is "is the same" "$(cksum <"$out/s2.ppm")" "$(cksum <"$out/s1.ppm")"
printf '\377\376x\0000\000' >"$out/utf16.csv"
sed 's/,/;/g; s/\./,/g' "$out/skin1.csv" >"$out/skin1_comma.csv"
is "a kernel of a profile with decimal commas" "$(build/sss_kernel "$out/skin1_comma.csv" --model pre --taps 7 | cksum)" "$(build/sss_kernel "$out/skin1.csv" --model pre --taps 7 | cksum)"
refuses "scores in UTF-16" "UTF-16" build/recommend "$out/utf16.csv"
refuses "materials in UTF-16" "UTF-16" build/preview $net "$out/utf16.csv" "$out/never.png"
refuses "a profile in UTF-16" "UTF-16" build/sss_kernel "$out/utf16.csv"
refuses "a folder of scores" "folder" build/recommend "$out"
refuses "a folder of materials" "folder" build/preview $net "$out" "$out/never.png"
refuses "a folder of a picture" "folder" build/lightmap "$out" "$out/never.png" --texels-per-mm 4
refuses "a folder of a profile" "folder" build/sss_kernel "$out"

echo "$passed passed, $failed failed"
[ $failed = 0 ]
