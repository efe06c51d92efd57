function handle = whirl_plot_spectrum(result, varargin)
% WHIRL_PLOT_SPECTRUM  Draws the strongest lines of the spectrum of a station at a point of a study.
%   WHIRL_PLOT_SPECTRUM(RESULT, POINT, STATION) draws amplitudes of x (zero to peak, in length scales) over orders,
%   multiples of the speed; POINT counts from 1, STATION is a name or a number. Gives the handle.
%
%   See also WHIRL_PLOT_ORBIT.
if ischar(result)
    result = whirl_read(result);
end
table = table_with(result, 'spectrum', {'detail', 'sweep', 'response'});
point = point_index(table, given(varargin, 1, []));
station = station_index(result, given(varargin, 2, []));
order = reshape(table.spectrum.lines(point, station, :, 1), [], 1);
amplitude = reshape(table.spectrum.lines(point, station, :, 2), [], 1);
there = ~isnan(order);
handle = stem(order(there), amplitude(there));
xlim([0, max([1; order(there)]) + 0.5]);
xlabel('order');
ylabel(['amplitude of x of ' plain_text(result.stations.name{station})]);
title(sprintf('point %d', point));
end
