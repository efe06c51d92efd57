function index = coordinate_index(coordinate, names)
% COORDINATE_INDEX  Returns the number of a coordinate, given by its name ('x', 'y', ...) or its number.
index = coordinate;
if ischar(coordinate)
    index = find(strcmp(names, coordinate));
end
if ~isnumeric(index) || numel(index) ~= 1 || ~any(index == 1:numel(names))
    error('whirl:badInput', 'there is no such coordinate, expected a number up to %d or one of: %s', numel(names), ...
        strtrim(sprintf('%s ', names{:})));
end
end
