#!/bin/bash
# One study by all processes of one job, which deal out the points among themselves:
#   sbatch mpi.sh CASE.yaml RESULT.h5
# It needs whirl-mpi, built with an MPI that srun can start here (listed by srun --mpi=list). mpirun works, too.
#SBATCH --job-name=whirl
#SBATCH --nodes=4
#SBATCH --ntasks-per-node=4
#SBATCH --cpus-per-task=8
#SBATCH --time=04:00:00
set -u
case=$1 result=$2

# Continue from the journals of an earlier job, if there are any.
resume=$(compgen -G "$result*" >/dev/null && echo --resume)

# A little less than --time: the result of what is done is written when the job ends.
# shellcheck disable=SC2086
srun --cpus-per-task="${SLURM_CPUS_PER_TASK:-1}" whirl-mpi run "$case" -o "$result" --quiet $resume \
    --max-time="${MAX_TIME:-3.9 h}" --threads "${SLURM_CPUS_PER_TASK:-1}"
status=$?

# Status 3: unfinished. The job is queued again, and continues with as many processes as it then gets.
if [ $status = 3 ]; then scontrol requeue "$SLURM_JOB_ID"; fi
exit $status
