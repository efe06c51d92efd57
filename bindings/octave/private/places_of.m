function [place, count] = places_of(table)
% PLACES_OF  Where in the study each point lies, from 0, and how many places it has: several starts share one, and the
%   points of a refined map lie in its finest grid.
about = table.attributes;
if isfield(about, 'grid') && about.grid > 0
    count = double(about.grid);
elseif isfield(about, 'places') && about.places > 0
    count = double(about.places);
else
    starts = 1;
    if isfield(about, 'starts')
        starts = double(about.starts);
    end
    count = floor(double(about.points) / starts);
end
place = mod(flat(table, double(table.point)) - 1, count);
end
