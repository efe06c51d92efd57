function [size_in_si, unit] = parameter_unit(result, name)
% PARAMETER_UNIT  The unit in which figures show a parameter: its size in SI and its name, '' of plain numbers.
size_in_si = 1;
unit = '';
at = find(strcmp(result.parameters.name, name), 1);
if ~isempty(at)
    size_in_si = result.parameters.shown_size(at);
    unit = result.parameters.shown_unit{at};
end
end
