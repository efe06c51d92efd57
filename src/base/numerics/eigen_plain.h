/// Settings of Eigen, to be included before it. Everything that depends on the processor is switched off (vector
/// instructions, threads, cache sizes), so that sums are added in one order everywhere.
#ifndef BASE_EIGEN_PLAIN_H
#define BASE_EIGEN_PLAIN_H

#define EIGEN_MPL2_ONLY
#define EIGEN_NO_DEBUG
#define EIGEN_DONT_VECTORIZE
#define EIGEN_DONT_PARALLELIZE
#define EIGEN_NO_CPUID
#define EIGEN_DEFAULT_L1_CACHE_SIZE 32768
#define EIGEN_DEFAULT_L2_CACHE_SIZE 262144
#define EIGEN_DEFAULT_L3_CACHE_SIZE 2097152

#endif
