#!/bin/bash
# Workers of a farm on a cluster with Slurm:
#
#   export COAPT_FARM=postgresql://worker@db.example.org/coapt    # the password in ~/.pgpass
#   sbatch --array=0-63 coapt-work.sh
#
# Each element is one worker, which ends when no work is left. A minute before the time limit Slurm sends SIGTERM: the worker gives back what
# it holds and ends. An element that is preempted, or whose node fails, is queued again.
#SBATCH --job-name=coapt-work
#SBATCH --array=0-15
#SBATCH --requeue
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --mem-per-cpu=1G
#SBATCH --time=04:00:00
#SBATCH --signal=B:TERM@60
#SBATCH --output=coapt-work-%A_%a.log
: "${COAPT_FARM:?is not set: the address of the farm database}"
exec coapt-farm work --until-dry --threads "${SLURM_CPUS_PER_TASK:-1}" --name "slurm-${SLURM_ARRAY_JOB_ID}-${SLURM_ARRAY_TASK_ID}"
