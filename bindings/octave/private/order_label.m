function label = order_label(full)
% ORDER_LABEL  What the axis of orders is called.
label = 'order';
if is_full(full)
    label = 'order, backward below 0';
end
end
