function along = axis_values(values, cover, dimension)
% AXIS_VALUES  The values of a parameter along the rows (1) or columns (2) of a plane; those that no point has lie
%   between their neighbours.
count = size(cover, dimension);
[points, first] = unique(cover(:), 'first');
first = first(points > 0);
points = points(points > 0);
% A point lies at the first cell that it stands for, of a square its corner.
[row, column] = ind2sub(size(cover), first);
place = row;
if dimension == 2
    place = column;
end
known = NaN(count, 1);
known(place) = values(points);
there = find(~isnan(known));
along = known;
if numel(there) > 1
    along = interp1(there, known(there), (1:count)', 'linear', 'extrap');
    along(there) = known(there);
end
end
