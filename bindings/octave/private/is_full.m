function yes = is_full(option)
% IS_FULL  Whether spectra are drawn with forward and backward whirl, and not of x alone.
if ~(islogical(option) || isnumeric(option)) || numel(option) ~= 1
    error('whirl:badInput', 'the option ''full'' is true or false');
end
yes = option ~= 0;
end
