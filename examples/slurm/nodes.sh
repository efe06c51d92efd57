#!/bin/bash
# One study on several nodes in one job, a shard on each, and the merge at the end:
#   sbatch nodes.sh CASE.yaml RESULT.h5
#SBATCH --job-name=whirl
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=1
#SBATCH --cpus-per-task=32
#SBATCH --time=04:00:00
set -u
case=$1 result=$2

# A little less than --time: the journals are complete when the job ends. srun gives every task its number.
# shellcheck disable=SC2016
srun bash -c 'exec whirl run "$0" -o "$1" --quiet --shard "$((SLURM_PROCID + 1))/$SLURM_NTASKS" --resume \
    --max-time="${MAX_TIME:-3.5 h}" --threads "${SLURM_CPUS_PER_TASK:-1}"' "$case" "$result"
status=$?

# Status 3: unfinished. The job is queued again, and continues on as many nodes as it then gets.
if [ $status = 3 ]; then scontrol requeue "$SLURM_JOB_ID"; fi
if [ $status != 0 ]; then exit $status; fi
srun --nodes=1 --ntasks=1 whirl merge "$case" -o "$result" --threads "${SLURM_CPUS_PER_TASK:-1}"
