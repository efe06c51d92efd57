# Studies of all kinds, or of those in the array kinds, in the current folder, with the results of runs without kills
# (whole-NAME.h5) and how long those took (span[NAME], milliseconds). Read by scripts that kill them: these define
# $whirl, $cases, $tests (tests/cli) and fail.

# Points one by one, along a line and in a plane; carried up and down, and confirmed; refined; confirmed and followed; at
# rest; along branches and on tori; of samples; records of motions and of runs.
[ -n "${kinds[*]:-}" ] || kinds=(plain map carry refined followed modes branch tori tolerances records runs)
sed -e 's/points: 5/points: 2000/' -e 's/, spectrum//' "$tests/good.yaml" >plain.yaml
sed -e 's/  sweep: .*/  map: {x: {parameter: omega, from: 1, to: 4, points: 60}, y: {parameter: kappa, from: 5, to: 20, points: 20}}/' \
    plain.yaml >map.yaml
sed -e 's/start: state/start: carry, direction: both/' -e 's/points: 2000/points: 300/' \
    -e 's/^study:/study:\n  confirm: yes/' plain.yaml >carry.yaml
sed -e 's/points: 2000/points: 100/' plain.yaml >refined.yaml
sed -e 's/from: 1.0, to: 0.1, points: 512/from: 0.28, to: 0.1, points: 10/' -e '/detail:/d' \
    -e 's/transient: 1100, record: 100/transient: 100, record: 400/' -e 's/revolution: 1024/revolution: 256/' \
    "$cases/paper.yaml" >followed.yaml
sed 's/points: 9/points: 41/' "$tests/modes.yaml" >modes.yaml
sed '/^study:/a\  tolerances: {parameters: {kappa: +- 20 %}, samples: 256}' "$tests/good.yaml" >tolerances.yaml
cp "$tests/branch.yaml" "$tests/tori.yaml" .
sed -n '/^cat >case.yaml/,/^END/p' "$(dirname "$tests")/determinism/dataset.sh" | sed '1d; $d' >records.yaml
sed -e 's/omega: {from: 0.7, to: 1.1}/omega: {from: 0.4, to: 0.6}/' -e 's/machines: 40/machines: 6/' -e '/integrate:/d' \
    -e 's/^    labels:/    runup: {speed_from: = omega, speed_to: 1.5, rate: 0.01, settle: 20}\n    labels:/' \
    records.yaml >runs.yaml
declare -A span
for name in "${kinds[@]}"; do
    refine=$([ $name = refined ] && echo --refine=1e5)
    before=$(date +%s%N)
    "$whirl" run $name.yaml -q $refine -o whole-$name.h5 >log 2>&1 || fail "the unperturbed run: $(cat log)"
    span[$name]=$((($(date +%s%N) - before) / 1000000))
done
