function from_zero(axes_handle, numbers)
% FROM_ZERO  Lets the vertical axis of amplitudes begin at 0, with room above the largest.
largest = max(numbers(:));
if largest > 0
    set(axes_handle, 'YLim', [0, 1.08 * largest]);
end
end
