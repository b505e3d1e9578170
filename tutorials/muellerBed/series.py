"""series.py -- frequency and amplitude of a time series, with intervals.

Rate       upward crossings of the mean per second. A crossing counts if the series was `BAND`
           standard deviations below the mean before it and is as far above it afterwards, so noise
           about the mean does not count. The interval is of the mean period: periods are nearly
           independent
Dominant   the frequency at which the spectrum is largest: mean of the spectra of blocks of three
           periods and at least 1 s, Hann's window. The interval is the jackknife over blocks, but
           at least half of the resolution of a block
Deviation  the standard deviation; jackknife over the same blocks

Intervals are half widths at 95 %.

SPDX-License-Identifier: GPL-3.0-or-later
"""
import collections

import numpy

import averages

STEP = 1e-3                         # s, of the even series
BAND = 0.25                         # standard deviations
LOWEST, HIGHEST = 0.5, 20.0         # Hz, where the largest is looked for

Course = collections.namedtuple("Course",
    "rate rate_interval dominant dominant_interval deviation deviation_interval "
                                          "periods blocks")


def even(time, values, step=STEP):
    """The series at equal steps, by linear interpolation."""
    at = numpy.arange(time[0], time[-1] + 0.5*step, step)
    return at, numpy.interp(at, time, values)


def crossings(time, values, band=BAND):
    """Times of the upward crossings of the mean."""
    values = (values - values.mean())/values.std()
    found, armed, last = [], False, None
    for k in range(1, len(values)):
        if values[k] < -band:
            armed, last = True, None
        if values[k - 1] < 0 <= values[k]:
            last = time[k - 1] + (time[k] - time[k - 1])*values[k - 1]/(values[k - 1] - values[k])
        if armed and last is not None and values[k] > band:
            found.append(last)
            armed = False
    return numpy.array(found)


def rate_of(found):
    """Crossings per second and the interval of it, from the periods between them."""
    periods = numpy.diff(found)
    if len(periods) < 2:
        return numpy.nan, numpy.nan
    rate = 1/periods.mean()
    return rate, rate**2*averages.student(len(periods) - 1)*periods.std(ddof=1)/len(periods)**0.5


def power(values, step=STEP):
    """Frequencies [Hz] and the power at them, padded with zeros to steps of 0.05 Hz or less."""
    size = 1 << int(numpy.ceil(numpy.log2(max(len(values), 20/step))))
    return numpy.fft.rfftfreq(size, step), abs(numpy.fft.rfft((values -
        values.mean())*numpy.hanning(len(values)), size))**2


def count_blocks(seconds, rate):
    """Number of blocks such that each has at least three periods and 1 s; three to twelve."""
    return int(numpy.clip(seconds*min(rate/3, 1) if numpy.isfinite(rate) else 0, 3, 12))


def course(time, values):
    """All results for a time series, of equal steps or not."""
    time, values = even(numpy.asarray(time, float), numpy.asarray(values, float))
    found = crossings(time, values)
    rate, rate_interval = rate_of(found)
    blocks = numpy.array_split(numpy.arange(len(time)), count_blocks(time[-1] - time[0], rate))
    spectra = numpy.array([power(values[block])[1] for block in blocks])
    frequency = power(values[blocks[0]])[0]
    where = (frequency > LOWEST) & (frequency < HIGHEST)
    dominant, dominant_interval = averages.jackknife(
        lambda chosen: frequency[where][numpy.argmax(spectra[chosen].mean(axis=0)[where])],
        averages.cut_blocks(len(blocks), len(blocks)))
    deviation, deviation_interval = averages.jackknife(lambda chosen: values[chosen].std(), blocks)
    return Course(rate, rate_interval, dominant, max(dominant_interval, 0.5/(len(blocks[0])*STEP)),
                  deviation, deviation_interval,
                  max(len(found) - 1, 0), len(blocks))
