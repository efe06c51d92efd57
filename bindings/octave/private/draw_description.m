function drawn = draw_description(data, axes_handle, titled)
% DRAW_DESCRIPTION  Draws a figure of docs/figures.md in the current figure window, by a rule for every shape of series.
%   DATA is the decoded document. Transparent colours are mixed with white, as lines of gnuplot have no opacity.
%   DRAW_DESCRIPTION(DATA, AXES, TITLED) draws its only panel into existing axes, with the figure's title if TITLED, and
%   returns the handles of its series.
scale = [];
if isfield(data, 'scale')
    scale = data.scale;
end
panels = list_of(data.panels);
if nargin > 1
    drawn = draw_alone(axes_handle, panels{1}, scale, data, titled);
    return
end
drawn = struct('figure', clf(), 'axes', [], 'legend', [], 'scale', [], 'data', data);
set(drawn.figure, 'Color', 'w', 'PaperUnits', 'centimeters', 'PaperSize', [data.width_cm, data.height_cm], ...
    'PaperPosition', [0, 0, data.width_cm, data.height_cm]);
outside = {};
for i = 1:numel(panels)
    drawn.axes = [drawn.axes; draw_panel(panels{i}, scale, data)];
    if panels{i}.legend_inside
        names_inside(drawn.axes(end), panels{i}, data);
    else
        outside = [outside; list_of(panels{i}.series)]; %#ok<AGROW>
    end
end
outside = named(outside);
if ~isempty(outside)
    drawn.legend = draw_legend([0, 1 - 0.85 / data.height_cm, 1, 0.85 / data.height_cm], outside, ...
        max(1, floor(data.width_cm / 2.6)), data.font_pt);
end
if ~isempty(scale)
    boxes = cell2mat(cellfun(@(panel) panel.box(:)', panels, 'UniformOutput', false));
    low = min(boxes(:, 3));
    drawn.scale = draw_scale([1 - 1.85 / data.width_cm, low, 0.35 / data.width_cm, max(boxes(:, 4)) - low], scale, ...
        data.font_pt);
end
end

function handles = draw_alone(axes_handle, panel, scale, data, titled)
% Draws a panel into existing axes with letters of 9 pt, marks and lines in proportion, a legend and a colour scale.
held = ishold(axes_handle);
font = 9;
before = {};
if held && ~isempty(get(axes_handle, 'Children'))
    before = {get(axes_handle, 'XLim'), get(axes_handle, 'YLim')};
end
clear_scale(axes_handle);
series = list_of(panel.series);
for i = 1:numel(series)
    series{i}.size = series{i}.size * font / data.font_pt;
end
panel.series = series;
panel.letter = '';
panel.title = '';
if titled
    panel.title = data.title;
end
set(axes_handle, 'Box', 'on', 'Layer', 'top');
handles = fill_panel(axes_handle, panel, scale, font);
list = named(series);
if ~isempty(list)
    name_series(axes_handle, list, series);
end
if ~isempty(scale)
    place = get(axes_handle, 'Position');
    setappdata(axes_handle, 'whirl_place', place);
    place = place .* [1, 1, 0.85, 0.88] + [0.03 * place(3), 0.07 * place(4), 0, 0];
    set(axes_handle, 'Position', place);
    bar = draw_scale([place(1) + 1.03 * place(3), place(2), 0.04 * place(3), place(4)], scale, font);
    setappdata(axes_handle, 'whirl_scale', bar);
    axes(axes_handle); %#ok<MAXES>
end
for i = 1:numel(before)
    keep_in_view(axes_handle, char('W' + i), before{i});
end
if held
    hold(axes_handle, 'on');
end
end

function keep_in_view(axes_handle, which, before)
% Widens the limits of an axis so that earlier contents stay visible.
limits = get(axes_handle, [which 'Lim']);
both = [min(limits(1), before(1)), max(limits(2), before(2))];
if ~isequal(both, limits)
    set(axes_handle, [which 'Lim'], both, [which 'TickMode'], 'auto', [which 'TickLabelMode'], 'auto');
end
end

function clear_scale(axes_handle)
% Removes an earlier colour scale, and gives the axes the place that they had before it.
if isappdata(axes_handle, 'whirl_place')
    set(axes_handle, 'Position', getappdata(axes_handle, 'whirl_place'));
    scale = getappdata(axes_handle, 'whirl_scale');
    if ishghandle(scale)
        delete(scale);
    end
    rmappdata(axes_handle, 'whirl_place');
end
end

function name_series(axes_handle, list, series)
% Places a legend in a corner with few points.
hold(axes_handle, 'on');
marks = [];
for i = 1:numel(list)
    one = list{i};
    one.x = NaN;
    one.y = NaN;
    if any(strcmp(one.shape, {'boxes', 'area'}))
        one.shape = 'dots';
        one.mark = 'square';
        one.size = 8;
    elseif ~strcmp(one.shape, 'dots')
        one.shape = 'line';
    end
    marks = [marks; draw_series(axes_handle, one, [], 9)]; %#ok<AGROW>
end
points = cellfun(@(one) [one.x(:), one.y(:)], series(cellfun(@(one) isfield(one, 'x') && ~isempty(one.x) && ...
    ~strcmp(one.shape, 'boxes'), series)), 'UniformOutput', false);
points = vertcat(zeros(0, 2), points{:});
names = cellfun(@(one) marked_up(one.name), list, 'UniformOutput', false);
if any(cellfun(@(one) strcmp(one.shape, 'boxes'), list))
    place_legend(axes_handle, marks, names);
else
    place_legend(axes_handle, marks, names, points(:, 1), points(:, 2));
end
hold(axes_handle, 'off');
end

function list = named(list)
% Returns the series that have a name, each name once.
names = cellfun(@(series) series.name, list, 'UniformOutput', false);
[~, first] = unique(names, 'first');
first = sort(first);
list = list(first(~cellfun(@isempty, names(first))));
end

function axes_handle = draw_panel(panel, scale, data)
font = data.font_pt;
left = panel.box(1);
bottom = panel.box(3);
axes_handle = axes('Position', [left, bottom, panel.box(2) - left, panel.box(4) - bottom], 'Box', 'on', ...
    'Layer', 'top', 'FontSize', 0.9 * font, 'LineWidth', 0.5, 'TickDir', 'in');
fill_panel(axes_handle, panel, scale, font);
if panel.y.shown && (panel.box(4) - panel.box(3)) * data.height_cm < 0.7
    % Lay the label of a low panel flat, as an upright one has no room.
    set(get(axes_handle, 'YLabel'), 'Rotation', 0, 'HorizontalAlignment', 'right', 'VerticalAlignment', 'middle');
end
end

function handles = fill_panel(axes_handle, panel, scale, font)
% Draws axes, series and title; returns the handles of the series.
handles = [];
hold(axes_handle, 'on');
set_axis(axes_handle, panel.x, 'X', font);
set_axis(axes_handle, panel.y, 'Y', font);
series = list_of(panel.series);
for i = 1:numel(series)
    if isfield(series{i}, 'x') && ~isempty(series{i}.x)
        handles = [handles; draw_series(axes_handle, series{i}, scale, 0.9 * font)]; %#ok<AGROW>
    end
end
if panel.equal
    set(axes_handle, 'DataAspectRatio', [1, 1, 1]);
end
heading = panel.title;
if ~isempty(panel.letter)
    heading = strtrim(['(' panel.letter ')  ' heading]);
end
if ~isempty(heading)
    title(axes_handle, marked_up(heading), 'FontWeight', 'normal', 'FontSize', 0.9 * font);
end
hold(axes_handle, 'off');
end

function set_axis(axes_handle, axis_data, which, font)
scales = {'linear', 'log'};
set(axes_handle, [which 'Scale'], scales{1 + axis_data.log}, [which 'Lim'], [axis_data.low, axis_data.high]);
at = [];
texts = {};
if isfield(axis_data, 'ticks')
    at = axis_data.ticks(:)';
    texts = cellfun(@marked_up, cellstr(axis_data.tick_texts), 'UniformOutput', false);
end
if ~axis_data.shown
    texts = repmat({''}, size(at));
end
set(axes_handle, [which 'Tick'], at, [which 'TickLabel'], texts);
if axis_data.shown
    labels = {@xlabel, @ylabel};
    label = labels{1 + (which == 'Y')};
    label(axes_handle, marked_up(axis_data.label), 'FontSize', font);
end
end

function text = marked_up(label)
% Converts a label: symbols between dollars become italic, the rest is unchanged.
parts = regexp(label, '\$', 'split');
for i = 1:numel(parts)
    if mod(i, 2) == 1
        parts{i} = regexprep(parts{i}, '([\\_^{}])', '\\$1');
    else
        parts{i} = ['{\it ' regexprep(parts{i}, '_\{', '}_{')];
        if isempty(strfind(parts{i}, '}_{')) %#ok<STREMP>
            parts{i} = [parts{i} '}'];
        end
    end
end
text = [parts{:}];
if any(text == 10)
    text = strrep(text, char(10), '\n');
end
end

function rgb = colour_of(series)
rgb = 1 - series.opacity * (1 - colour(series.colour));
end

function handles = draw_series(axes_handle, series, scale, font)
% Draws a series and returns its handles; texts have none.
handles = [];
x = series.x(:);
y = series.y(:);
switch series.shape
    case 'dots'
        handles = draw_dots(axes_handle, series, x, y);
    case 'line'
        handles = draw_line(axes_handle, series, x, y);
    case 'area'
        handles = draw_area(axes_handle, series, x, y);
    case 'bars'
        gap = NaN(size(x));
        handles = draw_line(axes_handle, series, reshape([x, x, gap]', [], 1), ...
            reshape([y, series.y_to(:), gap]', [], 1));
    case 'boxes'
        handles = draw_boxes(axes_handle, series, x, y, scale);
    case 'texts'
        draw_texts(axes_handle, series, x, y, font);
end
end

function handle = draw_dots(axes_handle, series, x, y)
names = {'disc', 'ring', 'square', 'frame', 'up', 'down', 'diamond', 'cross'};
markers = {'o', 'o', 's', 's', '^', 'v', 'd', 'x'};
empty = any(strcmp(series.mark, {'ring', 'frame'}));
handle = draw_marks(axes_handle, x, y, markers{strcmp(series.mark, names)}, series.size, colour_of(series), ~empty);
end

function handle = draw_line(axes_handle, series, x, y)
style = '-';
if isfield(series, 'dashed') && series.dashed
    style = '--';
end
handle = plot(axes_handle, x, y, style, 'Color', colour_of(series), 'LineWidth', series.size);
end

function handles = draw_area(axes_handle, series, x, y)
% Draws an area: for every run of points between gaps a polygon along y, and back along y_to.
to = series.y_to(:);
there = ~isnan(x) & ~isnan(y) & ~isnan(to);
starts = find(diff([false; there]) == 1);
ends = find(diff([there; false]) == -1);
handles = [];
for i = 1:numel(starts)
    run = starts(i):ends(i);
    handles = [handles; patch('Parent', axes_handle, 'XData', [x(run); flipud(x(run))], ...
        'YData', [y(run); flipud(to(run))], 'FaceColor', colour_of(series), 'EdgeColor', 'none')]; %#ok<AGROW>
end
end

function handle = draw_boxes(axes_handle, series, x, y, scale)
rgb = repmat(colour_of(series), numel(x), 1);
if isfield(series, 'values') && ~isempty(scale)
    rgb = colours_of(series.values(:), scale);
end
to = series.x_to(:);
up = series.y_to(:);
there = find(~isnan(x) & ~isnan(y) & ~any(isnan(rgb), 2));
x = [x(there), to(there), to(there), x(there)]';
y = [y(there), y(there), up(there), up(there)]';
faces = reshape(1:numel(x), 4, [])';
handle = patch('Parent', axes_handle, 'Vertices', [x(:), y(:)], 'Faces', faces, 'FaceVertexCData', rgb(there, :), ...
    'FaceColor', 'flat', 'EdgeColor', 'none');
end

function rgb = colours_of(values, scale)
% Returns the colours of numbers: interpolated between the colours of the scale, constant beyond its ends.
share = place_on(values, scale);
colours = colour(scale.colours);
rgb = interp1(linspace(0, 1, size(colours, 1)), colours, min(max(share, 0), 1));
end

function share = place_on(values, scale)
if scale.log
    values(values <= 0) = NaN;
    share = log(values / scale.low) / log(scale.high / scale.low);
else
    share = (values - scale.low) / (scale.high - scale.low);
end
end

function draw_texts(axes_handle, series, x, y, font)
sides = {'above', 'below', 'left', 'right', 'slanted', 'beside'};
horizontal = {'center', 'center', 'right', 'left', 'left', 'left'};
vertical = {'bottom', 'top', 'bottom', 'top', 'bottom', 'middle'};
side = strcmp(series.side, sides);
texts = cellstr(series.texts);
for i = 1:numel(texts)
    text(x(i), y(i), marked_up(texts{i}), 'Parent', axes_handle, 'FontSize', font, 'Color', colour(series.colour), ...
        'HorizontalAlignment', horizontal{side}, 'VerticalAlignment', vertical{side}, ...
        'Rotation', 60 * strcmp(series.side, 'slanted'));
end
end

function names_inside(panel_axes, panel, data)
% Draws a legend in the upper right corner of a panel.
list = named(list_of(panel.series));
if ~isempty(list)
    place = get(panel_axes, 'Position');
    high = 0.45 / data.height_cm;
    wide = min(place(3), numel(list) * 2.2 / data.width_cm);
    draw_legend([place(1) + place(3) - wide, place(2) + place(4) - high, wide, high], list, numel(list), data.font_pt);
end
end

function axes_handle = draw_legend(place, list, columns, font)
% Draws the figure's legend as rows of marks and names in axes of their own, as legends of Octave and MATLAB differ in
% place and have no columns.
columns = min(columns, numel(list));
rows = ceil(numel(list) / columns);
axes_handle = axes('Position', place, 'Visible', 'off', 'XLim', [0, columns], 'YLim', [0, rows]);
hold(axes_handle, 'on');
for i = 1:numel(list)
    x = mod(i - 1, columns) + 0.12;
    y = rows - floor((i - 1) / columns) - 0.5;
    sample(axes_handle, list{i}, x, y);
    text(x + 0.1, y, marked_up(list{i}.name), 'Parent', axes_handle, 'FontSize', 0.9 * font, ...
        'HorizontalAlignment', 'left', 'VerticalAlignment', 'middle');
end
hold(axes_handle, 'off');
set(axes_handle, 'XLim', [0, columns], 'YLim', [0, rows], 'Visible', 'off');
end

function sample(axes_handle, series, x, y)
switch series.shape
    case 'dots'
        series.size = max(3, series.size);
        draw_dots(axes_handle, series, x, y);
    case {'area', 'boxes'}
        series.x_to = x + 0.06;
        series.y_to = y + 0.25;
        draw_boxes(axes_handle, series, x - 0.06, y - 0.25, []);
    otherwise
        series.size = max(0.8, series.size);
        draw_line(axes_handle, series, [x - 0.07; x + 0.07], [y; y]);
end
end

function axes_handle = draw_scale(place, scale, font)
% Draws the colour scale as a bar.
axes_handle = axes('Position', place, 'Box', 'on', 'Layer', 'top', 'FontSize', 0.9 * font, 'XTick', [], ...
    'XLim', [0, 1], 'YAxisLocation', 'right');
hold(axes_handle, 'on');
% Use an axis from 0 to 1: gnuplot draws patches at a logarithmic axis on the right as if it were linear.
count = 128;
edges = linspace(0, 1, count + 1)';
middles = (edges(1:end - 1) + edges(2:end)) / 2;
series = struct('colour', '#000000', 'opacity', 1, 'x_to', ones(count, 1), 'y_to', edges(2:end), 'values', middles);
draw_boxes(axes_handle, series, zeros(count, 1), edges(1:end - 1), ...
    struct('low', 0, 'high', 1, 'log', false, 'colours', {scale.colours}));
set(axes_handle, 'YLim', [0, 1], 'YTick', []);
if isfield(scale, 'ticks')
    set(axes_handle, 'YTick', place_on(scale.ticks(:)', scale), 'YTickLabel', ...
        cellfun(@marked_up, cellstr(scale.tick_texts), 'UniformOutput', false));
end
ylabel(axes_handle, marked_up(scale.label), 'FontSize', font);
hold(axes_handle, 'off');
end
