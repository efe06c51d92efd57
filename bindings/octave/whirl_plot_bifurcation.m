function handle = whirl_plot_bifurcation(result, varargin)
% WHIRL_PLOT_BIFURCATION  Draws the bifurcation diagram of a sweep: sections over the parameter.
%   WHIRL_PLOT_BIFURCATION(RESULT) draws x of the first station once per revolution, in length scales.
%   WHIRL_PLOT_BIFURCATION(RESULT, STATION, COLUMN) draws that of a station (name or number); COLUMN is 1 for x, 2
%   for y, 3 and 4 for their velocities. RESULT is a struct of WHIRL_READ or the name of a file. Gives the handle.
%
%   See also WHIRL_READ, WHIRL_PLOT_POINCARE.
if ischar(result)
    result = whirl_read(result);
end
[table, name] = table_with(result, 'poincare', {'sweep', 'response', 'detail'}); %#ok<ASGLU>
station = station_index(result, given(varargin, 1, []));
column = given(varargin, 2, 1);
names = {'x', 'y', 'vx', 'vy'};
section = table.poincare.section(:, station, :, column);
values = reshape(section, numel(table.values), numel(section) / numel(table.values));
parameter = repmat(table.values(:), 1, size(values, 2));
handle = plot(parameter(:), values(:), 'k.', 'MarkerSize', 2);
xlabel(plain_text(table.attributes.parameter));
ylabel([names{column} ' of ' plain_text(result.stations.name{station})]);
title(plain_text(result.attributes.title));
end
