function handle = whirl_plot_poincare(result, varargin)
% WHIRL_PLOT_POINCARE  Draws the Poincare section of a station at a point of a study.
%   WHIRL_PLOT_POINCARE(RESULT, POINT, STATION) draws y over x once per revolution, in length scales; POINT counts
%   from 1, STATION is a name or a number. Gives the handle.
%
%   See also WHIRL_PLOT_ORBIT, WHIRL_PLOT_BIFURCATION.
if ischar(result)
    result = whirl_read(result);
end
table = table_with(result, 'poincare', {'detail', 'sweep', 'response'});
point = point_index(table, given(varargin, 1, []));
station = station_index(result, given(varargin, 2, []));
x = reshape(table.poincare.section(point, station, :, 1), [], 1);
y = reshape(table.poincare.section(point, station, :, 2), [], 1);
handle = plot(x, y, 'k.', 'MarkerSize', 6);
xlabel(['x of ' plain_text(result.stations.name{station})]);
ylabel(['y of ' plain_text(result.stations.name{station})]);
title(sprintf('point %d', point));
end
