function handle = whirl_plot_branches(result, varargin)
% WHIRL_PLOT_BRANCHES  Draws branches of periodic orbits: stable parts as lines, unstable ones dashed.
%   WHIRL_PLOT_BRANCHES(RESULT, STATION) draws the largest x of a station along an orbit, in length scales, over the
%   parameter; circles are special points (folds, doublings, ...). Gives the handles.
%
%   See also WHIRL_READ.
if ischar(result)
    result = whirl_read(result);
end
table = table_with(result, 'trace', {'branch'});
station = station_index(result, given(varargin, 1, []));
x = table.values(:);
y = table.trace.high(:, station, 1);
stable = double(table.trace.unstable(:) == 0);
begins = [true; diff(double(table.trace.number(:))) ~= 0 | diff(stable) ~= 0];
first = find(begins);
last = [first(2:end) - 1; numel(x)];
handle = zeros(numel(first), 1);
held = ishold();
for i = 1:numel(first)
    % One point further, so that parts of a branch meet.
    ending = min(last(i) + 1, numel(x));
    if table.trace.number(ending) ~= table.trace.number(first(i))
        ending = last(i);
    end
    style = 'r--';
    if stable(first(i))
        style = 'b-';
    end
    handle(i) = plot(x(first(i):ending), y(first(i):ending), style);
    hold on;
end
special = table.trace.special(:) ~= 0;
plot(x(special), y(special), 'ko', 'MarkerSize', 4);
if ~held
    hold off;
end
xlabel(plain_text(table.attributes.parameter));
ylabel(['largest x of ' plain_text(result.stations.name{station})]);
title(plain_text(result.attributes.title));
end
