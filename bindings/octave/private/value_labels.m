function value_labels(axes_handle, x, y, form)
% VALUE_LABELS  The values of marks beside them, in the form of sprintf; those that would lie on others go further up.
limits = axis(axes_handle);
span = [limits(2) - limits(1), limits(4) - limits(3)];
height = 0.055 * span(2);
taken = zeros(0, 3);
for i = 1:numel(x)
    words = sprintf(form, x(i));
    width = 0.0165 * (numel(words) + 2) * span(1);
    side = 'left';
    first = x(i);
    if first + width > limits(2)
        side = 'right';
        first = x(i) - width;
    end
    at = y(i) + 0.01 * span(2);
    if at + height > limits(4)
        at = y(i) - 0.01 * span(2) - height;
    end
    while any(abs(taken(:, 3) - at) < 0.9 * height & taken(:, 1) < first + width & taken(:, 2) > first) ...
            && at + 2 * height < limits(4)
        at = at + height;
    end
    taken(end + 1, :) = [first, first + width, at]; %#ok<AGROW>
    text(x(i), at, ['  ' words '  '], 'Parent', axes_handle, 'FontSize', 8, 'Interpreter', 'none', ...
        'HorizontalAlignment', side, 'VerticalAlignment', 'bottom');
end
end
