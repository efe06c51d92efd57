function check_index = point_index(table, point)
% POINT_INDEX  The number of a point of a table; [] for the first.
check_index = point;
if isempty(point)
    check_index = 1;
end
count = numel(table.values);
if numel(check_index) ~= 1 || check_index < 1 || check_index > count || check_index ~= floor(check_index)
    error('whirl:badInput', 'there is no such point, expected a number from 1 to %d', count);
end
end
