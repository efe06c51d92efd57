function place = point_index(table, point, at)
% POINT_INDEX  Returns the name of a point in names of figures (docs/figures.md): '#2' from its number POINT, which
% counts from 1 here and from 0 in the name; or '600 rpm' from AT, a value of the parameter, which is a number in SI or
% a text with any unit. Without both it returns the first point.
if ~isempty(at)
    if ~isempty(point)
        error('whirl:badInput', 'a point is given by its number or by ''at'', not by both');
    end
    place = text_of(at);
    if isnumeric(at) && numel(at) == 1 && isreal(at)
        place = sprintf('%.17g', at);
    elseif ~is_text(place)
        error('whirl:badInput', ...
            '''at'' takes a value of the parameter: a number in SI, or a text with a unit, ''600 rpm''');
    end
    return
end
if isempty(point)
    point = 1;
end
count = numel(flat(table, table.values));
if ~isnumeric(point) || numel(point) ~= 1 || point < 1 || point > count || point ~= floor(point)
    error('whirl:badInput', 'there is no such point, expected a number from 1 to %d', count);
end
place = sprintf('#%d', point - 1);
end
