function label = amplitude_label(subject)
% AMPLITUDE_LABEL  What an axis of amplitudes of the station is called, with the way in which they are counted.
about = subject.result.case_.attributes;
label = length_label(subject.result, ['amplitude of ' subject.station], about.shown_amplitude_unit);
end
