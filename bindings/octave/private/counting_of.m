function [counted, factor] = counting_of(result, meaning)
% COUNTING_OF  How lengths of a field of that meaning are counted, '' of places, and what they are multiplied by.
about = result.case_.attributes;
counted = '';
factor = 1;
if ~isempty(strfind(meaning, '0-p amplitude')) %#ok<STREMP>
    counted = about.shown_amplitude_unit;
    factor = about.shown_amplitude;
elseif ~isempty(strfind(meaning, '0-p')) %#ok<STREMP>
    counted = '0-p';
end
end
