function [size_in_si, unit] = parameter_unit(result, name)
% PARAMETER_UNIT  Returns the unit of a parameter in figures: its size in SI and its name, '' for plain numbers.
size_in_si = 1;
unit = '';
at = find(strcmp(result.parameters.name, name), 1);
if ~isempty(at)
    size_in_si = result.parameters.shown_size(at);
    unit = result.parameters.shown_unit{at};
end
end
