#!/bin/bash
# One study in an array of Slurm jobs, each task a shard of it:
#   id=$(sbatch --parsable array.sh CASE.yaml RESULT.h5)
#   sbatch --dependency=afterok:$id merge.sh CASE.yaml RESULT.h5
# To run single tasks of an array of 20: SHARDS=20 sbatch --array=3,5 array.sh CASE.yaml RESULT.h5
#SBATCH --job-name=whirl
#SBATCH --array=1-20
#SBATCH --cpus-per-task=8
#SBATCH --time=04:00:00
set -u
case=$1 result=$2
task=$SLURM_ARRAY_TASK_ID shards=${SHARDS:-$SLURM_ARRAY_TASK_COUNT}

# A little less than --time: the journal is complete when the task ends.
srun whirl run "$case" -o "$result" --quiet --shard "$task/$shards" --resume --max-time="${MAX_TIME:-3.9 h}" \
    --threads "${SLURM_CPUS_PER_TASK:-1}"
status=$?

# Status 3: unfinished. The task is queued again, and continues from its journal.
if [ $status = 3 ]; then scontrol requeue "${SLURM_ARRAY_JOB_ID}_$task"; fi
exit $status
