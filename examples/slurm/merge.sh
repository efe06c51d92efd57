#!/bin/bash
# The result of an array of jobs (array.sh):  sbatch merge.sh CASE.yaml RESULT.h5
#SBATCH --job-name=whirl-merge
#SBATCH --cpus-per-task=8
#SBATCH --time=04:00:00
set -u
srun whirl merge "$1" -o "$2" --threads "${SLURM_CPUS_PER_TASK:-1}"
