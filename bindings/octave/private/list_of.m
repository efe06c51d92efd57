function items = list_of(decoded)
% LIST_OF  Objects of an array of JSON: jsondecode makes one struct of those with the same keys, and a list of others.
if iscell(decoded)
    items = decoded(:);
else
    items = num2cell(decoded(:));
end
end
