function cover = cover_of(table, name, plane)
% COVER_OF  The point that stands for each cell of a plane [rows][columns], 0 where none is there.
%   Of a refined map that is the first corner of the square around the cell (docs/result-file.md), of several starts one
%   that goes where most do.
FIELD = field_names();
[place, count] = places_of(table);
columns = double(table.attributes.row);
rows = count / columns;
cover = zeros(rows, columns);
if has_field(table, FIELD.map_width)
    width = field_of(table, FIELD.map_width);
    for i = find(width > 1)'
        first = [floor(place(i) / columns), mod(place(i), columns)] + 1;
        past = first + width(i);
        % The last row or column goes with the squares that come up to it.
        past = past + (past >= [rows, columns]);
        cover(first(1):past(1) - 1, first(2):past(2) - 1) = i;
    end
end
order = (1:numel(place))';
if has_attractors(table, name) && ~strcmp(name, 'basin')
    share = flat(table, table.share);
    share(isnan(share)) = -1;
    % What most starts lead to is put there last.
    [ignored, order] = sortrows([share, -order]); %#ok<ASGLU>
end
for i = order'
    cover(floor(place(i) / columns) + 1, mod(place(i), columns) + 1) = i;
end
height = rows / plane_count(table);
cover = cover((plane - 1) * height + (1:height), :);
end
