function label = amplitude_label(result, what)
% AMPLITUDE_LABEL  What an axis of amplitudes is called, with the way in which they are counted.
about = result.case_.attributes;
way = about.shown_amplitude_unit;
if ~about.shown_length_over
    label = [what ' (' about.shown_length_unit ' ' way ')'];
else
    label = [what ' / ' about.shown_length_unit ' (' way ')'];
end
end
