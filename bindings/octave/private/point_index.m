function index = point_index(result, table, name, point, at)
% POINT_INDEX  The number of a point of a table: POINT itself, or the one whose parameter is nearest to AT; without
%   either the first. AT is a number in SI, or a text with a unit ('600 rpm').
values = flat(table, table.values);
index = point;
if ~isempty(at)
    if ~isempty(point)
        error('whirl:badInput', 'a point is told by its number or by ''at'', not by both');
    end
    [ignored, index] = min(abs(values - value_of(result, table, name, at))); %#ok<ASGLU>
elseif isempty(point)
    index = 1;
end
if ~isnumeric(index) || numel(index) ~= 1 || index < 1 || index > numel(values) || index ~= floor(index)
    error('whirl:badInput', 'there is no such point, expected a number from 1 to %d', numel(values));
end
end

function value = value_of(result, table, table_name, at)
% A value of the parameter, in SI.
name = table.attributes.parameter;
if isempty(name)
    error('whirl:badInput', 'nothing varies in the table ''%s'': a point is told by its number there', table_name);
end
[size_in_si, unit] = parameter_unit(result, name);
at = text_of(at);
value = NaN;
if isnumeric(at) && numel(at) == 1 && isreal(at)
    value = double(at);
elseif is_text(at)
    number = regexp(at, '^\s*[-+]?[\d.]+([eE][-+]?\d+)?', 'match', 'once');
    given = strtrim(at(numel(number) + 1:end));
    own = result.parameters.unit(strcmp(result.parameters.name, name));
    if strcmp(given, unit)
        value = str2double(number) * size_in_si;
    elseif any(strcmp(given, own))
        value = str2double(number);
    end
end
if isnan(value)
    error('whirl:badInput', ...
        '''at'' takes a value of %s: a number in SI, or a text with the unit of the figure, ''%s''', ...
        name, strtrim(['1 ' unit]));
end
end
