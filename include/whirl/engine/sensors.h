/// Sensors: signals of measuring chains for a computed motion.
///
/// A channel is a sensor at a station, its electronics and a converter. Motions are sampled behind an antialias filter:
/// a finite impulse response (sinc under a Kaiser window of WHIRL_SENSOR_REACH samples on either side) that is flat to
/// 1e-4 up to 0.42 of the rate and lets pass less than 1e-4 from 0.58 of the rate on. Parts of a signal up to 0.42 of
/// the rate are therefore free of aliases.
#ifndef WHIRL_SENSORS_H
#define WHIRL_SENSORS_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "whirl/engine/record.h"
#include "whirl/engine/running.h"
#include "whirl/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Limits of channels.
enum {
    WHIRL_MAX_CHANNELS = 32,  ///< channels of a record
    WHIRL_SENSOR_REACH = 16,  ///< samples before and after an instant that its filter uses
    WHIRL_SENSOR_INSTANTS = 4 ///< fewest instants of the motion between two samples
};

/// Kinds of sensors.
typedef enum whirl_sensor {
    WHIRL_SENSOR_PROXIMITY,     ///< distance of the shaft: gap, displacement and runout; m
    WHIRL_SENSOR_VELOCITY,      ///< velocity of the station; m/s
    WHIRL_SENSOR_ACCELEROMETER, ///< acceleration of the station; m/s2
    WHIRL_SENSOR_KEYPHASOR,     ///< pulses at angles of the shaft; 1
    WHIRL_SENSORS               ///< number of kinds
} whirl_sensor;

/// Returns the name of a kind in cases: "proximity"; for WHIRL_SENSORS the names of all kinds, separated by '|'.
/// Static.
const char *whirl_sensor_name(whirl_sensor sensor);

/// Returns the SI unit of the quantity that a kind of sensor measures; static.
const char *whirl_sensor_unit(whirl_sensor sensor);

/// Returns the SI unit of a kind's sensitivity, volts per unit of the quantity; static.
const char *whirl_sensor_sensitivity_unit(whirl_sensor sensor);

/// A channel. A number of 0 leaves out the part that it describes.
typedef struct whirl_channel {
    const char *name;    ///< borrowed
    whirl_sensor sensor; ///< its kind
    size_t station;      ///< index of its probe
    double angle;        ///< rad, its direction from the x axis towards y
    double gap;          ///< proximity, m: distance from the shaft at the centre
    double low, high;    ///< range in the unit of the sensor, to which signals are clipped; infinite: none
    double resonance;    ///< accelerometer, Hz: natural frequency of its spring and mass
    double damping;      ///< accelerometer: damping ratio of these, above 0 and below 1
    double high_pass;    ///< Hz: corner of a high pass of the first order
    int pulses;          ///< keyphasor: pulses of a turn
    double width;        ///< keyphasor: width of pulses, rad
    double jitter;       ///< rad, standard deviation of each pulse's angle
    bool in_volts;       ///< the signal and the following numbers are in volts; false: in the unit of the sensor
    double sensitivity;  ///< V per unit of the sensor; 1 without volts
    double noise;        ///< V, standard deviation of white noise at the converter
    double full_scale;   ///< V, the converter's range is from -full_scale to full_scale
    int bits;            ///< bits of the converter; 0: the signal is not rounded
} whirl_channel;

/// Sampling of a motion.
typedef struct whirl_sampling {
    size_t samples; ///< samples of a channel
    double rate;    ///< Hz
    double from;    ///< revolutions of the record before the first sample
    uint64_t seed;  ///< seed of noise and jitter
    double length;  ///< m of one unit of displacement (whirl_machine.length)
    double clock;   ///< rad/s, rate of the system's time (whirl_machine.clock)
} whirl_sampling;

/// Samples the motion of a run, whose speed changes, as whirl_channels_sample samples a record. Sample k is taken at
/// the instant `first` + k `ratio` of the motion. sampling->rate must be 1/(`ratio` times motion->step); sampling->from
/// and sampling->clock are not used. The motion must be complete and reach WHIRL_SENSOR_REACH samples beyond the first
/// and the last one. Pulses of a keyphasor begin at the angle 0 of the shaft, and are counted from there.
/// WHIRL_BAD_INPUT, WHIRL_NO_MEMORY.
whirl_status whirl_channels_sample_run(const whirl_run_motion *motion, const whirl_probe *probes, size_t first,
                                       size_t ratio, const whirl_channel *channels, size_t count,
                                       const whirl_sampling *sampling, float *out);

/// Samples a record with a waveform: out [count][sampling->samples], in V. The signal of a channel is a pure function
/// of the record, the channel, its index, and the sampling. The waveform must have WHIRL_SENSOR_INSTANTS instants or
/// more between two samples, and reach WHIRL_SENSOR_REACH samples beyond the first and the last. WHIRL_BAD_INPUT,
/// WHIRL_NO_MEMORY.
whirl_status whirl_channels_sample(const whirl_record *record, const whirl_channel *channels, size_t count,
                                   const whirl_sampling *sampling, float *out);

#ifdef __cplusplus
}
#endif
#endif
