#!/bin/bash
# Runs a test with the options that mpirun needs for tests:  mpi.sh COMMAND...
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
export OMPI_MCA_rmaps_base_oversubscribe=1 OMPI_MCA_hwloc_base_binding_policy=none
export OMPI_MCA_btl=self,vader OMPI_MCA_btl_vader_single_copy_mechanism=none OMPI_MCA_btl_vader_backing_directory=/tmp
if ! said=$(timeout 60 mpirun -n 2 true 2>&1 </dev/null); then
    echo "mpirun cannot start anything here, so this is left out: $(grep -m1 . <<<"$said")"
    exit 77
fi
exec "$@"
