function label = amplitude_label(result, what)
% AMPLITUDE_LABEL  What an axis of amplitudes is called, with the way in which they are counted where the case says it.
about = result.case_.attributes;
way = about.shown_amplitude_unit;
if ~about.shown_length_over
    label = [what ' (' strtrim([about.shown_length_unit ' ' way]) ')'];
elseif isempty(way)
    label = [what ' / ' about.shown_length_unit];
else
    label = [what ' / ' about.shown_length_unit ' (' way ')'];
end
end
