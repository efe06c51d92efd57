function handle = guide_line(axes_handle, x, y, style)
% GUIDE_LINE  A thin grey line that leads the eye (at 0, once a revolution); it is drawn first, below all else.
handle = plot(axes_handle, x, y, style, 'Color', [0.6, 0.6, 0.6], 'LineWidth', 0.75);
end
