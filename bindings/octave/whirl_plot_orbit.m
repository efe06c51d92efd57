function handle = whirl_plot_orbit(result, varargin)
% WHIRL_PLOT_ORBIT  Draws the orbit of a station at a point of a study that kept waveforms.
%   WHIRL_PLOT_ORBIT(RESULT, POINT, STATION) draws y over x, in length scales; POINT counts from 1, STATION is a name
%   or a number. The case must ask for waveforms: analyze: [waveform], keep: {waveform: 20}. Gives the handle.
%
%   See also WHIRL_PLOT_POINCARE.
if ischar(result)
    result = whirl_read(result);
end
table = table_with(result, 'waveform', {'detail', 'response', 'sweep'});
point = point_index(table, given(varargin, 1, []));
station = station_index(result, given(varargin, 2, []));
samples = table.waveform.samples;
x = reshape(samples(point, station, :, 1), [], 1);
y = reshape(samples(point, station, :, 2), [], 1);
handle = plot(x, y, 'b-');
axis equal;
xlabel(['x of ' plain_text(result.stations.name{station})]);
ylabel(['y of ' plain_text(result.stations.name{station})]);
title(sprintf('point %d', point));
end
