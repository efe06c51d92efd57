#!/bin/bash
# Every method in every kind of study, on 1 thread and on several: no run crashes, and threads change no digit.
#   every_study.sh GOOD.yaml        whirl is on the PATH; under a sanitizer it stops the script at what it finds
set -euo pipefail
good=$1
export ASAN_OPTIONS=detect_leaks=1:${ASAN_OPTIONS:-} OMP_WAIT_POLICY=passive

rk4='method: rk4, steps_per_revolution: 64, transient: 12, record: 8'
methods=(
    "$rk4"
    "$rk4, contacts: located"
    "${rk4/rk4/dop853}"
    "${rk4/rk4/rodas5p}"
    "${rk4/rk4/cvode-adams}"
    "${rk4/rk4/cvode-bdf}"
)
rubs=('damping: 0 N.s/m' 'damping: 0.3 N.s/m') # of the contact: then normal forces depend on velocities too
response='  response: {}'
points=$([ -n "${WHIRL_SANITIZED:-}" ] && echo 5 || echo 11)
sweep="  sweep: {parameter: omega, from: 1.0, to: 4.0, points: $points"
all='  keep: {waveform: 2}\n  confirm: yes\n  analyze: [poincare, orbit, rub, waveform, spectrum, lyapunov, exponents, '
all+='regime, winding, evidence, floquet]'
detail='  detail: {at: [1.5, 3.3], transient: 15, record: 10, waveform: 4}'
studies=(
    "$response\n$all"
    "$sweep, start: rest}\n$detail"
    "$sweep, start: state}\n$all"
    "  map: {x: {parameter: omega, values: [1, 2, 4]}, y: {parameter: kappa, from: 5, to: 20, points: 2}}\n$all"
    "${sweep/$points/5}, start: carry, direction: both}\n$all\n$detail"
)
threads=(2 3 4 5 7 8 12 16)

# JSON of the case in file $1, by 1 thread and by several. The other arguments go to whirl.
runs=0
compare() {
    local case=$1 number=${threads[$((runs % ${#threads[@]}))]}
    shift
    whirl "$@" "$case" --quiet --json --threads 1 >one.json
    whirl "$@" "$case" --quiet --json --threads "$number" >many.json
    if ! cmp one.json many.json; then
        echo "$* on $number threads differs from 1: $(cat "$case")"
        exit 1
    fi
    runs=$((runs + 1))
}

for rub in "${rubs[@]}"; do
    for method in "${methods[@]}"; do
        for study in "${studies[@]}"; do
            sed -e "s|law: paper}|law: paper, $rub}|" -e "s|{method: .*}|{$method}|" \
                -e '/^  analyze: /d' -e "s|^  sweep: .*|$study|" "$good" >study.yaml
            # CVODE takes no perturbations along; it goes alone and slowly, so that a few points do.
            if [[ $method = *cvode* ]]; then
                sed -i -e 's/exponents, //' -e '/confirm:/d' -e "s/points: $points/points: 3/" study.yaml
            fi
            grep -qF "$method" study.yaml && grep -qF "$rub" study.yaml
            compare study.yaml run
        done
        [[ $method != *cvode* ]] || continue
        # The last study again, carried on by refinement; and verified.
        sed -e '/confirm:/d' -e '/detail:/d' -e 's/start: carry, direction: both/start: state/' study.yaml \
            >doubtful.yaml
        compare doubtful.yaml run --refine=900
        compare doubtful.yaml verify --points 2 --revolutions 3
    done
done
echo "$runs studies, each the same on 1 thread and on several"
