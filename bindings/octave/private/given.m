function value = given(arguments, index, default)
% GIVEN  The argument of that index, or what stands for it.
value = default;
if numel(arguments) >= index
    value = arguments{index};
end
end
