function points = mark_size(count)
% MARK_SIZE  How large the marks of so many points are: few are seen, many do not hide one another.
sizes = [4.5, 3.5, 2.5, 2, 1.25];
points = sizes(1 + sum(count > [100, 600, 3000, 20000]));
end
