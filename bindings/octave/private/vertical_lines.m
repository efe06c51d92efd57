function handle = vertical_lines(axes_handle, x, low, high, rgb, width)
% VERTICAL_LINES  Lines at X from LOW to HIGH as one object, with gaps of NaN between them, and NaN alone where
%   there are none.
x = [x(:)'; x(:)'; NaN(1, numel(x))];
y = [low(:)'; high(:)'; NaN(1, numel(low))];
if isempty(x)
    x = NaN;
    y = NaN;
end
handle = plot(axes_handle, x(:), y(:), '-', 'Color', rgb, 'LineWidth', width);
end
